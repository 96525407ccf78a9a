//! What an escaped ray sees.

use glam::DVec3;

/// `[sky]`.
#[derive(Debug, Clone, PartialEq)]
pub enum Sky {
    /// One color; black unless the scene says otherwise.
    Color(DVec3),
    /// Nothing: no light comes from it, and files carry how much of a pixel shows it, as alpha.
    Transparent,
    /// An equirectangular picture: index into [`Scene::pictures`](super::Scene::pictures), and a factor on its radiance.
    Equirectangular(usize, f64),
    /// Six faces +x −x +y −y +z −z, seen from inside: indices into [`Scene::pictures`](super::Scene::pictures), and a factor.
    Faces([usize; 6], f64),
}

impl Sky {
    /// The WGSL part that shows it.
    #[must_use]
    pub fn part(&self) -> &'static str {
        match self {
            Self::Color(_) | Self::Transparent => "picture/sky/color",
            Self::Equirectangular(..) => "picture/sky/equirectangular",
            Self::Faces(..) => "picture/sky/faces",
        }
    }
}
