//! Matter in a thin disc round a hole.

use std::sync::Arc;

use glam::DVec3;

use super::{Facts, Kind, Surface, pattern};
use crate::document::keys;
use crate::document::values::{positive, positive_part};
use crate::model::{Row, row};

pub static KIND: Kind = Kind {
    name: "accretion",
    keys: keys! {
        temperature: "number above 0" = "none: white",
            "temperature of the hottest ring, in kelvins; without it, total radiance over all frequencies. Other rings follow from matter on circular orbits of the law (Page and Thorne 1974)";
        brightness: "number above 0" = "1", "luminance of the hottest ring, at rest";
        opacity: "number above 0, at most 1" = "1",
            "fraction of the light from behind that the disk absorbs, and its emissivity relative to a black body; below 1, every crossing of a ray adds light with its own redshift. Shadow rays treat it as opaque";
        color: "[red, green, blue], { checker, repeat }, { image, repeat }, { vertex_colors }" = "[1, 1, 1]", "factor on the emitted light";
    },
    read: |table, files| {
        let temperature = table.optional("temperature", positive);
        let brightness = table.or("brightness", 1.0, positive);
        let opacity = table.or("opacity", 1.0, positive_part);
        let color = pattern::read(table, "color", Some(DVec3::ONE), files)?;
        Some((color, Arc::new(Accretion { temperature, brightness, opacity })))
    },
};

/// Matter on circular orbits, as bright as what it loses to reach them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Accretion {
    /// Of the hottest ring, in kelvins; none if what is seen is all light together.
    pub temperature: Option<f64>,
    /// The luminance of the hottest ring, at rest.
    pub brightness: f64,
    /// The part of light that it holds back, and of a black body's that it sends.
    pub opacity: f64,
}

impl Surface for Accretion {
    fn facts(&self) -> Facts<'_> {
        Facts {
            has_temperature: true,
            orbits: true,
            opacity: self.opacity,
            ..Facts::ending("surface/material/accretion")
        }
    }

    fn values(&self) -> Row {
        row! { temperature: Float(self.temperature.unwrap_or(0.0)), brightness: Float(self.brightness) }
    }
}
