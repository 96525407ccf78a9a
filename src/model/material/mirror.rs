//! A mirror, whose color is its reflectance.

use std::sync::Arc;

use glam::DVec3;

use super::{Kind, Surface, SurfaceProperties, pattern};
use crate::document::keys;

pub static KIND: Kind = Kind {
    name: "mirror",
    keys: keys! {
        color: "[red, green, blue], { checker, repeat }, { image, repeat }, { vertex_colors }" = "[1, 1, 1]",
            "reflectance";
    },
    read: |table, files| Some((pattern::read(table, "color", Some(DVec3::ONE), files)?, Arc::new(Mirror))),
};

/// A surface that reflects rays.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Mirror;

impl Surface for Mirror {
    fn facts(&self) -> SurfaceProperties<'_> {
        SurfaceProperties::scattering("surface/scatter/mirror")
    }

    fn albedo(&self, color: DVec3) -> DVec3 {
        color
    }
}
