//! Media: how the index of refraction n varies with place.

use super::{Formula, IndexGrid, Profile};
use glam::DVec3;
use std::sync::Arc;

/// An index of refraction over space, in scene coordinates. Spherical media are functions of r, the distance from their centre.
#[derive(Debug, Clone, PartialEq)]
pub enum Medium {
    /// n everywhere.
    Constant {
        /// n.
        n: f64,
    },
    /// Luneburg's lens, generalised: n = √(C − r²/R²) (thesis Eq. 16).
    Luneburg {
        /// Where r is 0.
        center: DVec3,
        /// R.
        radius: f64,
        /// C ≥ 2.
        c: f64,
    },
    /// n = a e^(−b r²/R²).
    Gaussian {
        /// Where r is 0.
        center: DVec3,
        /// R.
        radius: f64,
        /// The index at the centre.
        a: f64,
        /// The exponent at R.
        b: f64,
    },
    /// n = k/r (thesis Eq. 17): paths are logarithmic spirals.
    InverseR {
        /// Where r is 0, and n infinite.
        center: DVec3,
        /// k.
        k: f64,
        /// What becomes of rays that go in.
        ingoing: Ingoing,
    },
    /// Maxwell's fisheye: n = n₀/(1 + r²/a²). Paths are circles.
    Fisheye {
        /// Where r is 0.
        center: DVec3,
        /// The index at the centre.
        n0: f64,
        /// Where the index is half of that.
        a: f64,
    },
    /// Eaton's lens: n² = 2R/r − 1. It sends every ray back to where it came from.
    Eaton {
        /// Where r is 0, and n infinite.
        center: DVec3,
        /// R.
        radius: f64,
    },
    /// A gradient rod: n = n₀ √(1 − g²ρ²), ρ the distance from its axis (Suffern and Getto 1991). Paths are sinusoidal.
    Rod {
        /// A point of the axis.
        center: DVec3,
        /// The axis, a unit vector.
        axis: DVec3,
        /// The index on the axis.
        n0: f64,
        /// g.
        g: f64,
    },
    /// n² = n₀² + gradient · (x − origin): paths are parabolas (Evans and Rosenquist 1985).
    Linear {
        /// Where the index is n₀.
        origin: DVec3,
        /// n₀.
        n0: f64,
        /// Of n².
        gradient: DVec3,
    },
    /// Exponential air: n = 1 + δ e^(−y/H), y the height over the origin.
    Exponential {
        /// Where y is 0.
        origin: DVec3,
        /// Along which y grows, a unit vector.
        up: DVec3,
        /// n − 1 at the origin.
        delta: f64,
        /// H.
        height: f64,
    },
    /// n = n₀ sech(g y), y the distance from a plane.
    Sech {
        /// A point of the plane.
        origin: DVec3,
        /// Its unit normal.
        up: DVec3,
        /// The index on it.
        n0: f64,
        /// g.
        g: f64,
    },
    /// Layered air: n by the height over the origin.
    Profile {
        /// A point of height 0.
        origin: DVec3,
        /// Along which height grows, a unit vector.
        up: DVec3,
        /// n by height.
        profile: Arc<Profile>,
    },
    /// Noise everywhere (thesis §2.4).
    Noise(Noise),
    /// Noise where light goes in or out, and straight paths between (thesis §5.2.1): for interiors only.
    Textured(Noise),
    /// Disturbed air: 1 outside a ball, noise in it.
    Explosion(Explosion),
    /// What the user wrote.
    Expression {
        /// Where x, y, z and r are 0.
        center: DVec3,
        /// The length over which it changes.
        scale: f64,
        /// n of the place relative to the centre. It may have no value, or none above 0, at some places: rays fail there.
        n: Formula,
    },
    /// Samples.
    Grid(Arc<IndexGrid>),
}

impl Medium {
    /// Have its paths a closed form? `ends` where they end at a given τ, which is not what spirals and circles are measured by.
    #[must_use]
    pub fn has_closed_form(&self, ends: bool) -> bool {
        match self {
            Self::Constant { .. }
            | Self::Textured(_)
            | Self::Luneburg { .. }
            | Self::Rod { .. }
            | Self::Linear { .. } => true,
            Self::InverseR { .. } | Self::Fisheye { .. } => !ends,
            _ => false,
        }
    }

    /// Is light bent in it?
    #[must_use]
    pub fn bends(&self) -> bool {
        !matches!(self, Self::Constant { .. } | Self::Textured(_))
    }

    /// Do rays end in its middle?
    #[must_use]
    pub fn captures(&self) -> bool {
        matches!(self, Self::InverseR { .. })
    }

    /// n at a place; 0 where a formula's n² is not positive, and no light comes; none of noise, which only the shaders know.
    #[must_use]
    pub fn index(&self, x: DVec3) -> Option<f64> {
        let root = |square: f64| square.max(0.0).sqrt();
        Some(match self {
            Self::Constant { n } => *n,
            Self::Luneburg { center, radius, c } => root(c - x.distance_squared(*center) / radius.powi(2)),
            Self::Gaussian { center, radius, a, b } => a * (-b * x.distance_squared(*center) / radius.powi(2)).exp(),
            Self::InverseR { center, k, .. } => k / x.distance(*center),
            Self::Fisheye { center, n0, a } => n0 / (1.0 + x.distance_squared(*center) / a.powi(2)),
            Self::Eaton { center, radius } => root(2.0 * radius / x.distance(*center) - 1.0),
            Self::Rod { center, axis, n0, g } => {
                n0 * root(1.0 - g.powi(2) * (x - center).reject_from_normalized(*axis).length_squared())
            }
            Self::Linear { origin, n0, gradient } => root(n0.powi(2) + gradient.dot(x - origin)),
            Self::Exponential { origin, up, delta, height } => {
                (1.0 + delta * (-up.dot(x - origin) / height).exp()).max(0.0)
            }
            Self::Sech { origin, up, n0, g } => n0 / (g * up.dot(x - origin)).cosh(),
            Self::Profile { origin, up, profile } => profile.index(up.dot(x - origin)),
            // Outside the disturbed region.
            Self::Explosion(noise) if x.distance(noise.center) >= noise.radius => 1.0,
            Self::Expression { center, n, .. } => n.value(x - *center),
            Self::Noise(_) | Self::Textured(_) | Self::Explosion(_) | Self::Grid(_) => return None,
        })
    }
}

/// What becomes of rays that move towards the centre of an inverse-r sphere.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ingoing {
    /// They wind into the centre and are captured there.
    Black,
    /// They are taken for outgoing ones: |d·b| stands for d·b (thesis Figs. 43 and 46).
    Continued,
}

/// A fractal sum of noise: n = n₀ + amplitude · Σ 2⁻ʲ noise(2ʲ · frequency · (x − c)).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Noise {
    /// c, a point of the lattice.
    pub center: DVec3,
    /// n₀.
    pub n0: f64,
    /// So small that n stays positive.
    pub amplitude: f64,
    /// Lattice cells a unit length.
    pub frequency: f64,
    /// Terms of the sum, 1 to 8.
    pub octaves: u32,
    /// Chooses the lattice's values.
    pub seed: u32,
}

impl Noise {
    /// What the sum of so many octaves stays within: at the middle of a cell a Catmull–Rom spline through values of ±1 reaches 5/4,
    /// and three of them, one along each axis, 125/64.
    #[must_use]
    pub fn reach(octaves: u32) -> f64 {
        125.0 / 64.0 * (2.0 - 2.0_f64.powi(1 - octaves.cast_signed()))
    }
}

/// The noise-based index of W04's Fig. 4(d): n = 1 + amplitude · ξ(r/R) · Σ 2⁻ʲ noise(2ʲ · frequency · (x − c)).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Explosion {
    /// Centre c of the disturbed region.
    pub center: DVec3,
    /// Its radius R: outside n = 1.
    pub radius: f64,
    /// In (−0.5, 0.5), so that n stays positive.
    pub amplitude: f64,
    /// Lattice cells a unit length.
    pub frequency: f64,
    /// Terms of the sum, 1 to 8.
    pub octaves: u32,
    /// Chooses the lattice's values.
    pub seed: u32,
}

/// What an object is filled with: light goes through it.
#[derive(Debug, Clone, PartialEq)]
pub struct Interior {
    /// Its index.
    pub medium: Medium,
    /// Where interiors overlap, the one of the higher priority is there.
    pub priority: u32,
}

/// The indices of common media (thesis Table 1), by the names that a scene file may write for them.
pub const COMMON: [(&str, f64); 11] = [
    ("vacuum", 1.0),
    ("air", 1.0003),
    ("ice", 1.31),
    ("water", 1.33),
    ("ethyl-alcohol", 1.36),
    ("fused-quartz", 1.46),
    ("acrylic", 1.49),
    ("crown-glass", 1.52),
    ("polyester-resin", 1.56),
    ("flint-glass", 1.66),
    ("diamond", 2.42),
];
