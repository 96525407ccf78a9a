//! The Blinn–Phong model with ambient, diffuse and specular terms (W04 §3.4).

use std::sync::Arc;

use glam::DVec3;

use super::{Kind, Surface, SurfaceProperties, pattern};
use crate::document::keys;
use crate::document::values::{color, number_where, positive};
use crate::model::{Row, row};

pub static KIND: Kind = Kind {
    name: "phong",
    keys: keys! {
        diffuse: "[red, green, blue], { checker, repeat }, { image, repeat }, { vertex_colors }" = "[0.8, 0.8, 0.8]",
            "color of the surface, linear RGB";
        ambient: "number from 0 to 1" = "0.1", "fraction of the color that is visible without light";
        specular: "[red, green, blue]" = "[0, 0, 0]", "color of the highlight";
        shininess: "number above 0" = "32", "exponent of the highlight";
        emission: "[red, green, blue]" = "[0, 0, 0]", "emitted radiance";
    },
    read: |table, files| {
        let fraction = number_where("a number from 0 to 1", |x| (0.0..=1.0).contains(&x));
        let usual = Phong::default();
        let phong = Phong {
            ambient: table.or("ambient", usual.ambient, fraction),
            specular: table.or("specular", usual.specular, color),
            shininess: table.or("shininess", usual.shininess, positive),
            emission: table.or("emission", usual.emission, color),
        };
        let diffuse = pattern::read(table, "diffuse", Some(DVec3::splat(0.8)), files)?;
        Some((diffuse, Arc::new(phong)))
    },
};

/// A surface lit by the scene's lights, with its color as the diffuse reflectance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Phong {
    /// The fraction of the color that is added without light.
    pub ambient: f64,
    /// The color of the highlight.
    pub specular: DVec3,
    /// The Blinn exponent.
    pub shininess: f64,
    /// The emitted radiance, which is added.
    pub emission: DVec3,
}

impl Default for Phong {
    fn default() -> Self {
        Self { ambient: 0.1, specular: DVec3::ZERO, shininess: 32.0, emission: DVec3::ZERO }
    }
}

impl Surface for Phong {
    fn facts(&self) -> SurfaceProperties<'_> {
        SurfaceProperties {
            is_lit: true,
            is_glossy: self.specular != DVec3::ZERO,
            ..SurfaceProperties::ending("surface/material/phong")
        }
    }

    fn values(&self) -> Row {
        row! {
            ambient: Float(self.ambient),
            specular: Vec3(self.specular),
            exponent: Float(self.shininess),
            emission: Vec3(self.emission),
        }
    }

    fn emission(&self, _color: DVec3) -> DVec3 {
        self.emission
    }

    fn albedo(&self, color: DVec3) -> DVec3 {
        color + self.specular
    }
}
