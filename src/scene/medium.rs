//! Media: how the index of refraction n varies with place.

use super::{Formula, IndexGrid};
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

/// What becomes of rays that move towards the centre of an inverse-r sphere.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ingoing {
    /// They wind into the centre and are captured there.
    Black,
    /// They are taken for outgoing ones: |d·b| stands for d·b (thesis Figs. 43 and 46).
    Continued,
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
