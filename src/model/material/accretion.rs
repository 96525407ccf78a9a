//! Matter in a thin disc round a hole.

use std::sync::Arc;

use glam::DVec3;

use super::{Kind, Surface, pattern};
use crate::document::keys;
use crate::document::values::positive;
use crate::model::{Row, row};

pub static KIND: Kind = Kind {
    name: "accretion",
    keys: keys! {
        temperature: "number above 0" = "none: white",
            "of the hottest ring, kelvins; without it all frequencies are shown together. The others' follow from the law's circular orbits (Page and Thorne 1974), on which matter goes round";
        brightness: "number above 0" = "1", "the luminance of the hottest ring, at rest";
        color: "[red, green, blue], { checker, repeat }, { image, repeat }" = "[1, 1, 1]", "its light times this";
    },
    read: |table, files| {
        let temperature = table.optional("temperature", positive);
        let brightness = table.or("brightness", 1.0, positive);
        let color = pattern::read(table, "color", Some(DVec3::ONE), files)?;
        Some((color, Arc::new(Accretion { temperature, brightness })))
    },
};

/// Matter on circular orbits, as bright as what it loses to reach them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Accretion {
    /// Of the hottest ring, in kelvins; none if what is seen is all light together.
    pub temperature: Option<f64>,
    /// The luminance of the hottest ring, at rest.
    pub brightness: f64,
}

impl Surface for Accretion {
    fn part(&self) -> &'static str {
        "surface/material/accretion"
    }

    fn values(&self) -> Row {
        row! { emission: Vec3(DVec3::new(self.temperature.unwrap_or(0.0), self.brightness, 0.0)) }
    }

    fn has_temperature(&self) -> bool {
        true
    }

    fn orbits(&self) -> bool {
        true
    }

    fn albedo(&self, _color: DVec3) -> DVec3 {
        DVec3::ZERO
    }
}
