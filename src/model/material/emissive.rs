//! A surface that radiates its colour.

use std::sync::Arc;

use super::{Kind, Surface, pattern};
use crate::document::keys;

pub static KIND: Kind = Kind {
    name: "emissive",
    keys: keys! {
        color: "[red, green, blue], { checker, repeat }, { image, repeat }" = "required", "radiance, linear";
    },
    read: |table, files| Some((pattern::read(table, "color", None, files)?, Arc::new(Emissive))),
};

/// Radiates its colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Emissive;

impl Surface for Emissive {
    fn part(&self) -> &'static str {
        "surface/material/emissive"
    }
}
