//! A surface that radiates as a black body.

use std::sync::Arc;

use glam::DVec3;

use super::{Kind, Surface, SurfaceProperties, pattern};
use crate::document::keys;
use crate::document::values::positive;
use crate::model::{Row, black_body, row};

pub static KIND: Kind = Kind {
    name: "blackbody",
    keys: keys! {
        temperature: "number above 0" = "required", "temperature, in kelvins";
        brightness: "number above 0" = "1", "luminance";
        color: "[red, green, blue], { checker, repeat }, { image, repeat }, { vertex_colors }" = "[1, 1, 1]", "factor on the emitted light";
    },
    read: |table, files| {
        let temperature = table.required("temperature", "5800", positive);
        let brightness = table.or("brightness", 1.0, positive);
        let color = pattern::read(table, "color", Some(DVec3::ONE), files)?;
        Some((color, Arc::new(Blackbody { temperature: temperature?, brightness })))
    },
};

/// A surface that radiates according to Planck's law.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Blackbody {
    /// The temperature in kelvins.
    pub temperature: f64,
    /// The luminance.
    pub brightness: f64,
}

impl Surface for Blackbody {
    fn facts(&self) -> SurfaceProperties<'_> {
        SurfaceProperties { has_temperature: true, ..SurfaceProperties::ending("surface/material/blackbody") }
    }

    fn temperature(&self) -> Option<f64> {
        Some(self.temperature)
    }

    fn values(&self) -> Row {
        row! { temperature: Float(self.temperature), brightness: Float(self.brightness) }
    }

    fn emission(&self, color: DVec3) -> DVec3 {
        self.brightness * color * black_body::color(self.temperature).0
    }
}
