//! Absorption and volumetric emission of media (T 2.3, 4.4).
//!
//! *Theory.* Over a length d the transmittance is e^(−σd), where σ is the absorption coefficient. A transmittance c per unit length means σ
//! = −ln c. The coefficient may vary over space by formulas or by a noise texture, and a medium may also emit light.
//!
//! *Practice.* An [`Absorption`] belongs to an interior or to the whole space of the law. Each kind of density has a function in
//! `shaders/absorption/density.wgsl`.

mod read;
mod texture;

use glam::DVec3;

use super::{Row, row};
use crate::assets::VolumeFormulas;

pub(crate) use read::{read, reference};
pub use texture::{NoiseColoring, Texture};

/// The absorption and emission of a medium.
#[derive(Debug, Clone, PartialEq)]
pub struct Absorption {
    /// The absorption.
    pub density: Density,
    /// The emitted radiance per unit length.
    pub emission: DVec3,
    /// The largest error of the optical depth of a piece of a path, and the largest relative error of its light.
    pub tolerance: f64,
    /// The origin of formulas and textures.
    pub center: DVec3,
}

/// The absorption of a medium.
#[derive(Debug, Clone, PartialEq)]
pub enum Density {
    /// A constant σ, per unit length.
    Even(DVec3),
    /// Formulas of σ, relative to the center.
    Formula(VolumeFormulas),
    /// Formulas of the transmittance per unit length.
    Color(VolumeFormulas),
    /// A texture of the transmittance per unit length.
    Texture(Texture),
}

/// Returns σ of a transmittance per unit length.
#[must_use]
pub fn density_of(color: DVec3) -> DVec3 {
    -color.max(DVec3::splat(1e-30)).map(f64::ln)
}

impl Absorption {
    /// The default tolerance, as coarse as the images of the published sources.
    pub const TOLERANCE: f64 = 1e-3;

    /// Creates a uniform filter from a transmittance per unit length.
    #[must_use]
    pub fn even(color: DVec3) -> Self {
        let density = Density::Even(density_of(color));
        Self { density, emission: DVec3::ZERO, tolerance: Self::TOLERANCE, center: DVec3::ZERO }
    }

    /// Returns the kind: `density_KIND` in `shaders/absorption/density.wgsl` computes the coefficient.
    #[must_use]
    pub fn kind(&self) -> &'static str {
        match &self.density {
            Density::Even(_) => "even",
            Density::Formula(_) => "formula",
            Density::Color(_) => "color_formula",
            Density::Texture(texture) => texture.kind(),
        }
    }

    /// Returns the formulas, if the density uses them.
    #[must_use]
    pub fn formulas(&self) -> Option<&VolumeFormulas> {
        match &self.density {
            Density::Formula(formulas) | Density::Color(formulas) => Some(formulas),
            Density::Even(_) | Density::Texture(_) => None,
        }
    }

    /// Returns the texture, if the density uses one.
    #[must_use]
    pub fn texture(&self) -> Option<&Texture> {
        match &self.density {
            Density::Texture(texture) => Some(texture),
            _ => None,
        }
    }

    /// Returns `true` if the density is discontinuous.
    #[must_use]
    pub fn jumps(&self) -> bool {
        self.texture().is_some_and(|texture| matches!(texture.look, NoiseColoring::Wrapped(..)))
    }

    /// Returns the members of its `Absorption` in WGSL; `formulas` is the index of its formulas.
    #[must_use]
    pub fn values(&self, formulas: usize) -> Row {
        let own = match &self.density {
            Density::Even(density) => row! { color: Vec3(*density), piece: Float(f64::from(f32::MAX)) },
            Density::Formula(_) | Density::Color(_) => {
                row! { which: Uint(formulas as u32), piece: Float(f64::from(f32::MAX)) }
            }
            Density::Texture(texture) => texture.values(),
        };
        let all = row! { emission: Vec3(self.emission), tolerance: Float(self.tolerance), center: Vec3(self.center) };
        [own, all].concat()
    }
}
