//! The background of escaped rays.

use glam::{DMat3, DVec3};

/// The table `[sky]`.
#[derive(Debug, Clone, PartialEq)]
pub enum Sky {
    /// One color; the default is black.
    Color(DVec3),
    /// A transparent sky, which emits no light; files store the visible fraction of each pixel as alpha.
    Transparent,
    /// An equirectangular environment map: its index in [`Scene::pictures`](super::Scene::pictures), a factor of its radiance, and its rotation
    /// from the axes of the map to the scene.
    Equirectangular(usize, f64, DMat3),
    /// A cube map with the faces +x −x +y −y +z −z, seen from inside: indices in [`Scene::pictures`](super::Scene::pictures), a factor, and its
    /// rotation.
    Faces([usize; 6], f64, DMat3),
}

impl Sky {
    /// Returns the WGSL module of the sky.
    #[must_use]
    pub fn part(&self) -> &'static str {
        match self {
            Self::Color(_) | Self::Transparent => "picture/sky/color",
            Self::Equirectangular(..) => "picture/sky/equirectangular",
            Self::Faces(..) => "picture/sky/faces",
        }
    }
}
