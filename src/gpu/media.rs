//! The values of media, by the names of their members in WGSL.

use super::contents::Source;
use super::records::Value::{self, Float, Uint, Uint4, Vec3};
use crate::scene::{Law, Medium};

impl Source<'_> {
    /// Of the medium that fills all space.
    pub(super) fn law_medium(&self) -> Vec<(&'static str, Value)> {
        match &self.scene.law {
            Law::Medium(medium) => medium_values(medium),
            _ => Vec::new(),
        }
    }

    /// Of the medium that fills all space.
    pub(super) fn index_samples(&self) -> &[f32] {
        match &self.scene.law {
            Law::Medium(Medium::Grid(grid)) => &grid.samples,
            _ => &[],
        }
    }
}

/// The members of `Medium` in the medium's part.
#[must_use]
pub fn medium_values(medium: &Medium) -> Vec<(&'static str, Value)> {
    match medium {
        Medium::Constant { n } => vec![("n", Float(*n))],
        Medium::Luneburg { center, radius, c } => {
            vec![("center", Vec3(*center)), ("radius", Float(*radius)), ("c", Float(*c))]
        }
        Medium::Gaussian { center, radius, a, b } => {
            vec![("center", Vec3(*center)), ("radius", Float(*radius)), ("a", Float(*a)), ("b", Float(*b))]
        }
        Medium::InverseR { center, k, .. } => vec![("center", Vec3(*center)), ("k", Float(*k))],
        Medium::Fisheye { center, n0, a } => {
            vec![("center", Vec3(*center)), ("n0", Float(*n0)), ("a", Float(*a))]
        }
        Medium::Eaton { center, radius } => vec![("center", Vec3(*center)), ("radius", Float(*radius))],
        Medium::Rod { center, axis, n0, g } => {
            vec![("center", Vec3(*center)), ("axis", Vec3(*axis)), ("n0", Float(*n0)), ("g", Float(*g))]
        }
        Medium::Linear { origin, n0, gradient } => {
            vec![("origin", Vec3(*origin)), ("n0", Float(*n0)), ("gradient", Vec3(*gradient))]
        }
        Medium::Exponential { origin, up, delta, height } => {
            vec![("origin", Vec3(*origin)), ("up", Vec3(*up)), ("delta", Float(*delta)), ("height", Float(*height))]
        }
        Medium::Sech { origin, up, n0, g } => {
            vec![("origin", Vec3(*origin)), ("up", Vec3(*up)), ("n0", Float(*n0)), ("g", Float(*g))]
        }
        Medium::Explosion(n) => vec![
            ("center", Vec3(n.center)),
            ("radius", Float(n.radius)),
            ("amplitude", Float(n.amplitude)),
            ("frequency", Float(n.frequency)),
            ("octaves", Uint(n.octaves)),
            ("seed", Uint(n.seed)),
        ],
        Medium::Expression { center, scale, .. } => vec![("center", Vec3(*center)), ("scale", Float(*scale))],
        Medium::Grid(grid) => vec![
            ("origin", Vec3(grid.origin)),
            ("cell", Vec3(grid.cell)),
            ("size", Uint4([grid.size[0], grid.size[1], grid.size[2], 0])),
        ],
    }
}
