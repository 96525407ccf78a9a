//! Closed forms: motions of light that need no solver.
//!
//! *Practice.* Media whose paths have the same form share a motion; what they differ by is the medium's own part.

use super::same::named;

/// A motion in closed form.
pub struct ClosedForm {
    /// Its name.
    pub name: &'static str,
    /// The WGSL parts that keep the contract `motion`.
    pub parts: &'static [&'static str],
    /// May one step lead through a whole region, where nothing else is in it?
    pub leaps: bool,
    /// Are its paths straight?
    pub is_line: bool,
    /// Has its stride to know what it may meet, besides the surface that it leaves by?
    pub meets_obstacles: bool,
    /// How a ray starts there: by a part, or as the region's index has it.
    pub start: Start,
}

/// Who says how a ray starts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Start {
    /// The motion's own part.
    Own,
    /// With |v| = n.
    ByIndex,
    /// By the index if there is one, else as it is given.
    ByIndexIfAny,
}

/// Straight on.
pub static STRAIGHT: ClosedForm = ClosedForm {
    name: "straight",
    parts: &["motion/straight", "motion/pace_tau", "motion/closed"],
    leaps: false,
    is_line: true,
    meets_obstacles: false,
    start: Start::ByIndexIfAny,
};

/// As on a spring.
pub static HARMONIC: ClosedForm = ClosedForm {
    name: "harmonic",
    parts: &["motion/harmonic", "motion/pace_tau", "motion/closed"],
    leaps: true,
    is_line: false,
    meets_obstacles: false,
    start: Start::ByIndex,
};

/// Along logarithmic spirals.
pub static SPIRAL: ClosedForm = ClosedForm {
    name: "spiral",
    parts: &["motion/spiral", "motion/spiral_stride", "motion/closed"],
    leaps: true,
    is_line: false,
    meets_obstacles: true,
    start: Start::Own,
};

/// In circles.
pub static CIRCLE: ClosedForm = ClosedForm {
    name: "circle",
    parts: &["motion/circle", "motion/closed"],
    leaps: true,
    is_line: false,
    meets_obstacles: false,
    start: Start::ByIndex,
};

/// Along parabolas.
pub static PARABOLA: ClosedForm = ClosedForm {
    name: "parabola",
    parts: &["motion/parabola", "motion/pace_tau", "motion/closed"],
    leaps: false,
    is_line: false,
    meets_obstacles: false,
    start: Start::ByIndex,
};

impl ClosedForm {
    /// Returns `true` if a path may end at a given τ: its parts know how far that is.
    #[must_use]
    pub fn ends(&self) -> bool {
        self.parts.contains(&"motion/pace_tau")
    }
}

named!(ClosedForm);
