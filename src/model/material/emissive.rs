//! A surface that radiates its color.

use std::sync::Arc;

use glam::DVec3;

use super::{Kind, Surface, SurfaceProperties, pattern};
use crate::document::keys;
use crate::document::values::{boolean, color};
use crate::model::{Row, row};

pub static KIND: Kind = Kind {
    name: "emissive",
    keys: keys! {
        color: "[red, green, blue], { checker, repeat }, { image, repeat }, { vertex_colors }" = "required", "emitted radiance, linear RGB";
        diffuse: "[red, green, blue]" = "[0, 0, 0]", "diffuse reflectance, for path tracing";
        light_sampling: "true | false" = "true", "use next-event estimation for this emitter";
    },
    read: |table, files| {
        let usual = Emissive::default();
        let emissive = Emissive {
            diffuse: table.or("diffuse", usual.diffuse, color),
            is_aimed_at: table.or("light_sampling", usual.is_aimed_at, boolean),
        };
        Some((pattern::read(table, "color", None, files)?, Arc::new(emissive)))
    },
};

/// A surface that radiates its color.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Emissive {
    /// The fraction of incident light that the surface reflects diffusely in path tracing.
    pub diffuse: DVec3,
    /// Is `true` if next-event estimation samples the surface.
    pub is_aimed_at: bool,
}

impl Default for Emissive {
    fn default() -> Self {
        Self { diffuse: DVec3::ZERO, is_aimed_at: true }
    }
}

impl Surface for Emissive {
    fn facts(&self) -> SurfaceProperties<'_> {
        SurfaceProperties { is_aimed_at: self.is_aimed_at, ..SurfaceProperties::ending("surface/material/emissive") }
    }

    fn values(&self) -> Row {
        row! { diffuse: Vec3(self.diffuse) }
    }

    fn emission(&self, color: DVec3) -> DVec3 {
        color
    }

    fn albedo(&self, _color: DVec3) -> DVec3 {
        self.diffuse
    }
}
