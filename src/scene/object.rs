//! `[[objects]]` and `[materials.NAME]`: what there is to meet, and what it is made of.

use super::{Interior, Mesh, Transform};
use glam::{DVec2, DVec3};

/// `[materials.NAME]`.
#[derive(Debug, Clone, PartialEq)]
pub struct Material {
    /// The name in the file.
    pub name: String,
    /// The colour that its kind uses, over the surface.
    pub color: Pattern,
    /// How it answers light.
    pub kind: MaterialKind,
}

/// How a material answers light.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum MaterialKind {
    /// Reflects rays, with its colour as the part that it gives back.
    Mirror,
    /// Radiates its colour.
    Emissive,
    /// Ambient, diffuse and Blinn–Phong specular terms (W04 §3.4), with its colour as the diffuse one.
    Phong {
        /// Fraction of the colour that is always there.
        ambient: f64,
        /// Colour of the highlight.
        specular: DVec3,
        /// Blinn's exponent.
        shininess: f64,
        /// Radiance of its own, added.
        emission: DVec3,
    },
}

/// A colour over a surface's (u, v).
#[derive(Debug, Clone, PartialEq)]
pub enum Pattern {
    /// The same everywhere.
    Constant(DVec3),
    /// Two colours in turn.
    Checker {
        /// The two colours.
        colors: [DVec3; 2],
        /// Cells along u and v.
        repeat: DVec2,
    },
    /// A picture: index into [`Scene::pictures`](super::Scene::pictures).
    Picture {
        /// Which.
        picture: usize,
        /// How often it repeats along u and v.
        repeat: DVec2,
    },
}

impl Pattern {
    /// Does it give all colours the same part?
    #[must_use]
    pub fn is_gray(&self) -> bool {
        let gray = |color: &DVec3| *color == DVec3::splat(color.x);
        match self {
            Self::Constant(color) => gray(color),
            Self::Checker { colors, .. } => colors.iter().all(gray),
            Self::Picture { .. } => false,
        }
    }
}

/// `[[objects]]`: a shape in its own space, where it is, and what it is made of.
#[derive(Debug, Clone)]
pub struct Object {
    /// The shape.
    pub shape: Shape,
    /// From the shape's own space to the scene's.
    pub transform: Transform,
    /// What it is made of.
    pub substance: Substance,
}

/// What an object is made of.
#[derive(Debug, Clone, PartialEq)]
pub enum Substance {
    /// A surface: index into [`Scene::materials`](super::Scene::materials).
    Opaque(usize),
    /// A medium that light goes through.
    Clear(Interior),
}

impl Object {
    /// The index of its material, if it has one.
    #[must_use]
    pub fn material(&self) -> Option<usize> {
        match self.substance {
            Substance::Opaque(material) => Some(material),
            Substance::Clear(_) => None,
        }
    }

    /// What it is filled with, if light goes through it.
    #[must_use]
    pub fn interior(&self) -> Option<&Interior> {
        match &self.substance {
            Substance::Opaque(_) => None,
            Substance::Clear(interior) => Some(interior),
        }
    }
}

/// Shapes, each in its own space; `Object::transform` holds the file's center, radius, size and so on.
#[derive(Debug, Clone)]
pub enum Shape {
    /// The unit sphere. u runs round y, v from the south to the north pole.
    Sphere,
    /// The square |x| ≤ 1, |z| ≤ 1 in y = 0, its normal +y. (u, v) = ((x+1)/2, (1−z)/2).
    Plane,
    /// The cube |x|, |y|, |z| ≤ 1; each face has (u, v) in [0, 1].
    Box,
    /// The cylinder x² + z² ≤ 1, |y| ≤ 1 with both faces. u runs round y; v runs upwards, over each of the lower face (from
    /// its middle to the rim), the mantle and the upper face (from the rim to its middle).
    Cylinder,
    /// The disk x² + z² ≤ 1 in y = 0, its normal +y. u runs round y, v from the rim to the middle, or to the hole.
    Disk {
        /// The radius of a round hole in it, below 1; zero for none.
        hole: f64,
    },
    /// Triangles.
    Mesh(std::sync::Arc<Mesh>),
}
