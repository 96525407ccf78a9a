//! A surface that reflects in a lobe around the mirror direction (T 2.2.3).

use std::sync::Arc;

use glam::DVec3;

use super::{Kind, Surface, SurfaceProperties, pattern};
use crate::document::keys;
use crate::document::values::not_negative;
use crate::model::{Row, row};

pub static KIND: Kind = Kind {
    name: "glossy",
    keys: keys! {
        color: "[red, green, blue], { checker, repeat }, { image, repeat }, { vertex_colors }" = "[1, 1, 1]",
            "reflectance";
        exponent: "number, 0 or above" = "required",
            "exponent e: directions follow a cosᵉ lobe around the mirror direction; light below the surface is lost";
    },
    read: |table, files| {
        let exponent = table.required("exponent", "100", not_negative);
        let color = pattern::read(table, "color", Some(DVec3::ONE), files);
        Some((color?, Arc::new(Glossy { exponent: exponent? })))
    },
};

/// A surface that reflects rays in a lobe around the mirror direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Glossy {
    /// The exponent e of cosᵉ.
    pub exponent: f64,
}

impl Surface for Glossy {
    fn facts(&self) -> SurfaceProperties<'_> {
        SurfaceProperties { has_lobe: true, ..SurfaceProperties::scattering("surface/scatter/glossy") }
    }

    fn values(&self) -> Row {
        row! { exponent: Float(self.exponent) }
    }

    fn albedo(&self, color: DVec3) -> DVec3 {
        color
    }
}
