//! Vertex colors: one for each position of a file, linear and from 0 to 1.
//!
//! *Theory.* OBJ and PLY do not specify the encoding of their colors. Programs that paint and scan meshes write display values,
//! which are sRGB, and readers such as three.js decode them as sRGB. The colors of glTF are linear by its specification.
//!
//! *Practice.* A file with invalid colors is still read, because most scenes do not use them. The error is stored for the scenes that do.

use glam::{DVec3, Vec3};

use super::Mesh;
use crate::assets::picture::decode_srgb;

/// The largest distance of a component from the range 0 to 1: half a step of eight bits.
const ROUNDING: f64 = 0.5 / 255.0;

/// The colors of a file's positions.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Colors {
    /// The linear colors by position; positions after the end are white.
    linear: Vec<Vec3>,
    /// The reason why the first unusable color cannot be used.
    flaw: Option<String>,
}

impl Colors {
    /// Sets the color of a position, from 0, given in sRGB. Positions before it without a color are white.
    pub fn set_srgb(&mut self, position: usize, color: [f64; 3]) {
        self.set(position, color, decode_srgb);
    }

    /// Sets the color of a position as [`Self::set_srgb`] does, given as a linear color.
    pub fn set_linear(&mut self, position: usize, color: [f64; 3]) {
        self.set(position, color, |x| x);
    }

    fn set(&mut self, position: usize, color: [f64; 3], decoded: impl Fn(f64) -> f64) {
        if !color.iter().all(|x| (-ROUNDING..=1.0 + ROUNDING).contains(x)) {
            let [red, green, blue] = color;
            self.reject(format!(
                "vertex {position}, counted from 0, has the color [{red}, {green}, {blue}], outside the range from 0 \
                 to 1"
            ));
        }
        self.linear.resize(position, Vec3::ONE);
        self.linear.push(DVec3::from(color.map(|x| decoded(x.clamp(0.0, 1.0)))).as_vec3());
    }

    /// Records the reason why the colors cannot be used; only the first reason is kept.
    pub fn reject(&mut self, flaw: String) {
        self.flaw.get_or_insert(flaw);
    }

    /// Returns `true` if there are usable colors.
    pub fn are_there(&self) -> bool {
        !self.linear.is_empty() && self.flaw.is_none()
    }

    /// Returns the color of a position; white if it has none.
    pub fn get(&self, position: u32) -> Vec3 {
        self.linear.get(position as usize).copied().unwrap_or(Vec3::ONE)
    }

    /// Returns the reason why the colors cannot be used, if any.
    pub fn flaw(&self) -> Option<&str> {
        self.flaw.as_deref()
    }
}

impl Mesh {
    /// Returns the reason why the mesh has no vertex colors, as a sentence; `None` if it has them.
    #[must_use]
    pub fn lacks_colors(&self) -> Option<String> {
        if !self.colors.is_empty() {
            return None;
        }
        let none = || "this mesh has no vertex colors".to_owned();
        let wrong = |flaw: &String| format!("the vertex colors of this mesh cannot be used: {flaw}");
        Some(self.color_flaw.as_ref().map_or_else(none, wrong))
    }

    /// Returns the linear color of each vertex; white if the mesh has no colors.
    pub fn colors_or_white(&self) -> impl Iterator<Item = Vec3> {
        (0..self.vertices.len()).map(|i| self.colors.get(i).copied().unwrap_or(Vec3::ONE))
    }

    /// Returns the mean of the linear colors over the surface, in object space; white without colors.
    #[must_use]
    pub fn mean_color(&self) -> DVec3 {
        if self.colors.is_empty() {
            return DVec3::ONE;
        }
        let weighted = self.triangles.iter().map(|triangle| {
            let [a, b, c] = triangle.map(|i| self.vertices[i as usize].position.as_dvec3());
            let area = (b - a).cross(c - a).length();
            (area, area * triangle.map(|i| self.colors[i as usize].as_dvec3()).iter().sum::<DVec3>() / 3.0)
        });
        let (area, color) = weighted.fold((0.0, DVec3::ZERO), |all, one| (all.0 + one.0, all.1 + one.1));
        color / area
    }
}
