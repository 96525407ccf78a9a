//! `[rays]`: how rays are followed.

use glam::DVec3;

/// `[rays]`: how rays are followed.
#[derive(Debug, Clone, PartialEq)]
pub struct Rays {
    /// The integrator.
    pub method: Method,
    /// How long its steps are.
    pub control: Control,
    /// How accurate rays shall be, where the scene leaves method and control to a calibration; until that has run they are
    /// RK4's.
    pub auto: Option<Accuracy>,
    /// What is tested against the scene.
    pub segment: Segment,
    /// A ray that has this many segments and is still under way is exhausted.
    pub max_segments: u32,
    /// Rays that leave this sphere have escaped.
    pub bound: Bound,
    /// Rays end at this τ.
    pub length: Option<f64>,
    /// Outside the bounding sphere rays are followed to infinity in closed form.
    pub asymptotic: bool,
    /// Bits of the numbers.
    pub precision: Precision,
    /// Where a medium's paths have a closed form it stands for the method.
    pub closed_forms: bool,
    /// Does one step lead through a region that has nothing else in it? Paths that are to be drawn are cut into arcs.
    pub leaps: bool,
    /// How the rays that a surface splits are followed.
    pub branches: Branches,
    /// How the objects that a segment may meet are searched.
    pub accelerate: Accelerate,
}

/// What stands between a segment and the objects. All give the same picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Accelerate {
    /// What measures best.
    Auto,
    /// A bounding volume hierarchy.
    Hierarchy,
    /// A uniform grid (G95 §4).
    Grid,
    /// Nothing: every segment is tested against every object (W04).
    None,
}

/// What is followed where a surface both reflects and transmits.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Branches {
    /// Both, exactly, up to so many times along a path: what would split once more is cut.
    Enumerated(u32),
    /// One of them at random, a sample.
    Random,
}

/// The error in a ray's direction that 99 of 100 rays shall stay under.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Accuracy {
    /// In parts of the angle of a pixel at the picture's centre.
    Pixels(f64),
    /// In radians.
    Radians(f64),
}

/// The integrators.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Method {
    /// Closed forms only.
    Exact,
    /// The orbit's equation in the ray's own plane; laws with one centre only.
    Planar,
    /// p ← p + h F(p) (W04 Eq. 2).
    Euler,
    /// Drift, kick, drift: of order 2; laws of the second order that depend on place alone.
    Leapfrog,
    /// Nyström's method of order 4; laws as for leapfrog.
    Rkn4,
    /// The classical fourth-order Runge–Kutta method.
    Rk4,
    /// The pair of orders 3 and 2.
    BogackiShampine,
    /// The pair of orders 5 and 4.
    DormandPrince,
    /// Straight until the index has changed by more than the threshold, then Snell's law (W04 §5.3); media only.
    Snell {
        /// The change of index that refracts.
        threshold: f64,
    },
}

/// Step-size rules. Every length here is a τ; η is a fraction of the law's own scale.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Control {
    /// Not applicable: one closed-form arc to the end.
    Exact,
    /// h is constant.
    Fixed {
        /// h.
        step: f64,
        /// The cap: h ≤ η · scale.
        eta: f64,
    },
    /// h = η · scale.
    Scaled {
        /// η.
        eta: f64,
    },
    /// Every step turns the ray through the same angle (G95 Fig. 6b).
    Curvature {
        /// Radians.
        turn: f64,
        /// The cap: h ≤ η · scale.
        eta: f64,
    },
    /// One step h against two of h/2 (W04 §4.2).
    Doubling {
        /// The paper's rule or a rejecting one.
        rule: DoublingRule,
        /// h shrinks above this relative difference.
        tolerance: f64,
        /// h grows below this relative difference.
        grow_below: f64,
        /// The cap: h ≤ η · scale.
        eta: f64,
    },
    /// An embedded pair's own error, kept under the tolerance by a PI controller.
    Embedded {
        /// Of each step's relative error.
        tolerance: f64,
        /// The cap: h ≤ η · scale.
        eta: f64,
    },
}

/// The two step-doubling rules.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DoublingRule {
    /// Two thresholds; only the next step changes (W04 §4.2).
    Paper,
    /// A step over the tolerance is tried again, shorter.
    Rejecting,
}

/// What of a path is tested against the scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Segment {
    /// One accepted step as a cubic Hermite arc, cut into chords that stay within `tolerance` of it.
    Arc {
        /// Scene units.
        tolerance: f64,
    },
    /// The paper's polygon: one chord over N steps.
    Chord {
        /// N.
        steps: u32,
    },
}

/// The bounding sphere.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bound {
    /// Its centre.
    pub center: DVec3,
    /// Its radius.
    pub radius: f64,
}

/// Bits of the numbers that a path is followed in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Precision {
    /// Followed in 32 bits, kept between passes in 16, as in 2004.
    Half,
    /// 32.
    Single,
    /// 64, where the device has them.
    Double,
}

impl Precision {
    /// All, from the fewest bits to the most.
    pub const ALL: [Self; 3] = [Self::Half, Self::Single, Self::Double];

    /// As users write it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Half => "f16",
            Self::Single => "f32",
            Self::Double => "f64",
        }
    }

    /// In a few words.
    #[must_use]
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Half => "32 bits, kept in 16 between passes as in 2004",
            Self::Single => "32 bits",
            Self::Double => "64 bits, where the device has them",
        }
    }
}
