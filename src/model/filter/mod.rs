//! What a medium takes from light on its way, or adds to it (thesis 2.3, 4.4).
//!
//! *Theory.* Of light that goes a length d a part e^(−σd) is left, where σ is the density; a color c that is left after a unit length
//! has σ = −ln c. A density may vary over space, by formulas or by a texture of noise, and a medium may glow.
//!
//! *Practice.* A [`Filter`] belongs to an interior, or to the law's whole space. Each kind of density has a function
//! of its own in `shaders/filter/density.wgsl`.

mod read;
mod texture;

use glam::DVec3;

use super::{Row, row};
use crate::assets::Formula;

pub(crate) use read::{read, reference};
pub use texture::{Look, Texture};

/// What a medium does to light on its way.
#[derive(Debug, Clone, PartialEq)]
pub struct Filter {
    /// How much it takes.
    pub density: Density,
    /// Radiance that it adds, per unit length.
    pub glow: DVec3,
    /// How far the optical depths of a piece of path and of its halves may differ.
    pub tolerance: f64,
    /// Where formulas and textures have their origin.
    pub center: DVec3,
}

/// How much a filter takes of light.
#[derive(Debug, Clone, PartialEq)]
pub enum Density {
    /// The same everywhere: σ, per unit length.
    Even(DVec3),
    /// σ by formulas of the place from the center, one for each channel.
    Formula([Formula; 3]),
    /// The color that is left after a unit length, by formulas.
    Color([Formula; 3]),
    /// That color by a texture.
    Texture(Texture),
}

/// σ of a color that is left after a unit length.
#[must_use]
pub fn density_of(color: DVec3) -> DVec3 {
    -color.max(DVec3::splat(1e-30)).map(f64::ln)
}

impl Filter {
    /// As coarse as the sources' pictures.
    pub const TOLERANCE: f64 = 1e-3;

    /// Of a color that is left after a unit length, everywhere the same.
    #[must_use]
    pub fn even(color: DVec3) -> Self {
        let density = Density::Even(density_of(color));
        Self { density, glow: DVec3::ZERO, tolerance: Self::TOLERANCE, center: DVec3::ZERO }
    }

    /// Its kind: `density_KIND` in `shaders/filter/density.wgsl` is its density.
    #[must_use]
    pub fn kind(&self) -> &'static str {
        match &self.density {
            Density::Even(_) => "even",
            Density::Formula(_) => "formula",
            Density::Color(_) => "color_formula",
            Density::Texture(texture) => texture.kind(),
        }
    }

    /// Its formulas, if it is made of them.
    #[must_use]
    pub fn formulas(&self) -> Option<&[Formula; 3]> {
        match &self.density {
            Density::Formula(formulas) | Density::Color(formulas) => Some(formulas),
            Density::Even(_) | Density::Texture(_) => None,
        }
    }

    /// Its texture, if it has one.
    #[must_use]
    pub fn texture(&self) -> Option<&Texture> {
        match &self.density {
            Density::Texture(texture) => Some(texture),
            _ => None,
        }
    }

    /// Does its density jump from place to place?
    #[must_use]
    pub fn jumps(&self) -> bool {
        self.texture().is_some_and(|texture| matches!(texture.look, Look::Wrapped(..)))
    }

    /// The members of its `Filter` in WGSL that are its own; its formulas are those of this number.
    #[must_use]
    pub fn values(&self, formulas: usize) -> Row {
        let own = match &self.density {
            Density::Even(density) => row! { color: Vec3(*density), piece: Float(f64::from(f32::MAX)) },
            Density::Formula(_) | Density::Color(_) => {
                row! { which: Uint(formulas as u32), piece: Float(f64::from(f32::MAX)) }
            }
            Density::Texture(texture) => texture.values(),
        };
        let all = row! { glow: Vec3(self.glow), tolerance: Float(self.tolerance), center: Vec3(self.center) };
        [own, all].concat()
    }
}
