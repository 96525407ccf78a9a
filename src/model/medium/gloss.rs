//! The roughness of a transparent object's surface.
//!
//! *Theory.* A smooth surface has two rays, by the Fresnel equations and Snell's law. A rough surface spreads both. T 2.2.3 uses lobes
//! around them, and loses light that the lobes send to the wrong side. Walter et al. (2007) use microfacets, each a smooth surface, and
//! lose only light that would be scattered twice.
//!
//! *Practice.* Each model has a module in `shaders/surface/scatter/`, which samples one direction.

use crate::document::reader::TableReader;
use crate::document::values::{number_where, positive};

use crate::model::{Row, row};

/// The roughness of a transparent object's surface.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub enum Gloss {
    /// A smooth surface.
    #[default]
    Smooth,
    /// Lobes with a density cosᵉ around the smooth surface's two rays; an exponent is `None` for a smooth ray.
    Lobes {
        /// The exponent of the reflection lobe.
        reflect: Option<f64>,
        /// The exponent of the transmission lobe.
        transmit: Option<f64>,
    },
    /// Microfacets with a Trowbridge–Reitz (GGX) slope distribution.
    Microfacets {
        /// The width a of the distribution, which is about the slope of most facets.
        roughness: f64,
    },
}

impl Gloss {
    /// Returns the name of the WGSL module that scatters rays at the surface.
    #[must_use]
    pub fn part(self) -> &'static str {
        match self {
            Self::Smooth => "surface/scatter/transmissive",
            Self::Lobes { .. } => "surface/scatter/frosted",
            Self::Microfacets { .. } => "surface/scatter/microfacet",
        }
    }

    /// Returns the members of its `Material` in WGSL that only this surface has.
    #[must_use]
    pub fn values(self) -> Row {
        match self {
            Self::Smooth => Row::new(),
            Self::Lobes { reflect, transmit } => row! {
                exponent: Float(reflect.unwrap_or(0.0)),
                transmit_exponent: Float(transmit.unwrap_or(0.0)),
            },
            Self::Microfacets { roughness } => row! { roughness: Float(roughness) },
        }
    }
}

/// Reads the keys of an interior that describe its surface.
pub(super) fn read(table: &TableReader) -> Gloss {
    let [reflect, transmit] = ["reflect_exponent", "transmit_exponent"].map(|key| table.optional(key, positive));
    let fraction = number_where("a number above 0, at most 1", |x| x > 0.0 && x <= 1.0);
    match (table.optional("roughness", fraction), reflect, transmit) {
        (None, None, None) => Gloss::Smooth,
        (None, ..) => Gloss::Lobes { reflect, transmit },
        (Some(roughness), None, None) => Gloss::Microfacets { roughness },
        (Some(_), ..) => {
            let help = "keep either `roughness` (microfacets) or the exponents (lobes)";
            table.fault(
                &["roughness"],
                "`roughness` cannot be combined with `reflect_exponent` or `transmit_exponent`",
                help,
            );
            Gloss::Smooth
        }
    }
}
