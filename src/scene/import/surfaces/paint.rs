//! The color of a surface in the format of a material's key.

use std::fmt;

use glam::DVec3;

use super::super::text::{color, quoted};

/// A color or an image, optionally multiplied by vertex colors.
pub(super) struct Paint {
    pub base: Base,
    pub has_vertex_colors: bool,
}

/// The factor that vertex colors multiply.
#[derive(Clone)]
pub(super) enum Base {
    Color(DVec3),
    /// The path of an image.
    Image(String),
}

impl Paint {
    /// Returns the color, if it is constant.
    pub fn constant(&self) -> Option<DVec3> {
        match self.base {
            Base::Color(color) if !self.has_vertex_colors => Some(color),
            _ => None,
        }
    }
}

impl fmt::Display for Paint {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let vertex_colors = if self.has_vertex_colors { ", vertex_colors = true" } else { "" };
        match &self.base {
            Base::Color(base) if self.has_vertex_colors => write!(f, "{{ color = {}{vertex_colors} }}", color(*base)),
            Base::Color(base) => write!(f, "{}", color(*base)),
            Base::Image(path) => write!(f, "{{ image = {}{vertex_colors} }}", quoted(path)),
        }
    }
}
