//! Matter in a thin accretion disk around a black hole.

use std::sync::Arc;

use glam::DVec3;

use super::{Kind, Surface, SurfaceProperties, pattern};
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

/// Matter on circular orbits that radiates the energy released by viscosity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Accretion {
    /// The temperature of the hottest ring, in kelvins; `None` to show the bolometric flux.
    pub temperature: Option<f64>,
    /// The luminance of the hottest ring in its rest frame.
    pub brightness: f64,
    /// The fraction of light that the disk absorbs, which is also its emissivity relative to a black body.
    pub opacity: f64,
}

impl Surface for Accretion {
    fn facts(&self) -> SurfaceProperties<'_> {
        SurfaceProperties {
            has_temperature: true,
            orbits: true,
            opacity: self.opacity,
            ..SurfaceProperties::ending("surface/material/accretion")
        }
    }

    fn temperature(&self) -> Option<f64> {
        self.temperature
    }

    fn values(&self) -> Row {
        row! { temperature: Float(self.temperature.unwrap_or(0.0)), brightness: Float(self.brightness) }
    }
}
