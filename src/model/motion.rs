//! Closed forms: motions of light that need no solver.
//!
//! *Practice.* Media whose paths have equal form share a motion; a module of the medium supplies the differences.

use super::dyn_eq::named;

/// A motion in closed form.
pub struct ClosedForm {
    /// The name.
    pub name: &'static str,
    /// The WGSL modules that implement the contract `motion`.
    pub parts: &'static [&'static str],
    /// Is `true` if one step may cross a whole region that contains nothing else.
    pub leaps: bool,
    /// Is `true` if paths are straight.
    pub is_line: bool,
    /// Is `true` if the stride depends on possible obstacles, in addition to the surface where the path leaves.
    pub meets_obstacles: bool,
    /// The initialization of a ray.
    pub start: Start,
}

/// The rule for the velocity of a ray at its start.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Start {
    /// A WGSL module of the motion defines it.
    Own,
    /// The speed is |v| = n.
    ByIndex,
    /// The speed is |v| = n if there is an index; otherwise v is unchanged.
    ByIndexIfAny,
}

/// The straight motion.
pub static STRAIGHT: ClosedForm = ClosedForm {
    name: "straight",
    parts: &["motion/straight", "motion/pace_tau", "motion/closed"],
    leaps: false,
    is_line: true,
    meets_obstacles: false,
    start: Start::ByIndexIfAny,
};

/// The harmonic motion.
pub static HARMONIC: ClosedForm = ClosedForm {
    name: "harmonic",
    parts: &["motion/harmonic", "motion/pace_tau", "motion/closed"],
    leaps: true,
    is_line: false,
    meets_obstacles: false,
    start: Start::ByIndex,
};

/// The motion along logarithmic spirals.
pub static SPIRAL: ClosedForm = ClosedForm {
    name: "spiral",
    parts: &["motion/spiral", "motion/spiral_stride", "motion/closed"],
    leaps: true,
    is_line: false,
    meets_obstacles: true,
    start: Start::Own,
};

/// The motion along circles.
pub static CIRCLE: ClosedForm = ClosedForm {
    name: "circle",
    parts: &["motion/circle", "motion/closed"],
    leaps: true,
    is_line: false,
    meets_obstacles: false,
    start: Start::ByIndex,
};

/// The motion along parabolas.
pub static PARABOLA: ClosedForm = ClosedForm {
    name: "parabola",
    parts: &["motion/parabola", "motion/pace_tau", "motion/closed"],
    leaps: false,
    is_line: false,
    meets_obstacles: false,
    start: Start::ByIndex,
};

impl ClosedForm {
    /// Returns `true` if a path may end at a given τ, which requires modules that measure τ.
    #[must_use]
    pub fn ends(&self) -> bool {
        self.parts.contains(&"motion/pace_tau")
    }
}

named!(ClosedForm);
