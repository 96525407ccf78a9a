//! The background of escaped rays.

use glam::DVec3;

/// The table `[sky]`.
#[derive(Debug, Clone, PartialEq)]
pub enum Sky {
    /// One color; the default is black.
    Color(DVec3),
    /// A transparent sky, which emits no light; files store the visible fraction of each pixel as alpha.
    Transparent,
    /// An equirectangular environment map: its index in [`Scene::pictures`](super::Scene::pictures), and a factor of its radiance.
    Equirectangular(usize, f64),
    /// A cube map with the faces +x −x +y −y +z −z, seen from inside: indices in [`Scene::pictures`](super::Scene::pictures), and a factor.
    Faces([usize; 6], f64),
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
