//! How rough the surface of a clear object is.
//!
//! *Theory.* A smooth surface has two rays, by Fresnel's law and Snell's. A rough one spreads both: the thesis (2.2.3) by lobes about
//! them, whose light below the surface is lost; Walter et al. (2007) by microfacets, each a smooth surface, of which
//! only that is lost which would be scattered twice.
//!
//! *Practice.* Each has a part of its own in `shaders/surface/scatter/`, which chooses one direction a sample.

use crate::document::reader::TableReader;
use crate::document::values::{number_where, positive};

use crate::model::{Row, row};

/// How rough the surface of a clear object is.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub enum Gloss {
    /// Not at all.
    #[default]
    Smooth,
    /// Lobes as dense as cosᵉ about the smooth surface's two rays: the exponents, none where one is smooth.
    Lobes {
        /// Of what is reflected.
        reflect: Option<f64>,
        /// Of what goes through.
        transmit: Option<f64>,
    },
    /// Facets whose slopes are spread by the law of Trowbridge and Reitz (GGX).
    Microfacets {
        /// Its width a, about the slope of most facets.
        roughness: f64,
    },
}

impl Gloss {
    /// The name of the WGSL part that sends rays on from it.
    #[must_use]
    pub fn part(self) -> &'static str {
        match self {
            Self::Smooth => "surface/scatter/transmissive",
            Self::Lobes { .. } => "surface/scatter/frosted",
            Self::Microfacets { .. } => "surface/scatter/microfacet",
        }
    }

    /// The members of its `Material` in WGSL that are its own.
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

/// The keys of an interior that belong to its surface.
pub(super) fn read(table: &TableReader) -> Gloss {
    let [reflect, transmit] = ["reflect_exponent", "transmit_exponent"].map(|key| table.optional(key, positive));
    let fraction = number_where("a number above 0, at most 1", |x| x > 0.0 && x <= 1.0);
    match (table.optional("roughness", fraction), reflect, transmit) {
        (None, None, None) => Gloss::Smooth,
        (None, ..) => Gloss::Lobes { reflect, transmit },
        (Some(roughness), None, None) => Gloss::Microfacets { roughness },
        (Some(_), ..) => {
            let help = "keep `roughness` for microfacets, or the exponents for the thesis's lobes";
            table.fault(&["roughness"], "a surface is rough in one way", help);
            Gloss::Smooth
        }
    }
}
