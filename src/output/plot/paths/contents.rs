//! What a ray diagram shows.

use glam::DVec3;

use crate::measure::{Curve, Focus};
use crate::scene::{CutPlane, Outline};

/// The path of one ray.
#[derive(Debug, Clone, PartialEq)]
pub struct PathLine<'a> {
    /// Where it goes, in scene coordinates.
    pub curve: Curve,
    /// The name of how the ray ended.
    pub status: &'a str,
}

/// What a line in which something crosses the plane is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SurfaceKind {
    /// An object's opaque surface.
    Opaque,
    /// The surface of an object that light goes through.
    Medium,
    /// A sphere of the law where rays end, by its name.
    Capture(&'static str),
    /// Any other sphere of the law, by its name.
    Limit(&'static str),
}

/// Where something crosses the plane.
#[derive(Debug, Clone, PartialEq)]
pub struct CrossSection {
    /// What it is.
    pub kind: SurfaceKind,
    /// Where it crosses.
    pub outlines: Vec<Outline>,
}

/// Which part of the plane is shown.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PlotRange {
    /// All paths and the bounding sphere.
    All,
    /// The surfaces' box, widened by half; all if there are none.
    Objects,
    /// [left, right, bottom, top] in scene units, at least: a unit is equally long in both directions.
    Given([f64; 4]),
}

/// A ray diagram.
#[derive(Debug, Clone, PartialEq)]
pub struct PathPlot<'a> {
    /// The plane that is shown.
    pub plane: CutPlane,
    /// The part of it.
    pub range: PlotRange,
    /// The paths.
    pub lines: Vec<PathLine<'a>>,
    /// What crosses the plane.
    pub surfaces: Vec<CrossSection>,
    /// Center and radius of the bounding sphere, if it is to be shown.
    pub bound: Option<(DVec3, f64)>,
    /// Places to mark, with their spread.
    pub foci: Vec<Focus>,
    /// A point to mark, and how often each path goes round it, in turns.
    pub windings: Option<(DVec3, Vec<f64>)>,
    /// Where the orbits of a flow go in the long run, behind all else.
    pub attractor: Option<Curve>,
}

impl<'a> PathPlot<'a> {
    /// Paths alone, all of them.
    #[must_use]
    pub fn new(plane: CutPlane, lines: Vec<PathLine<'a>>) -> Self {
        let surfaces = Vec::new();
        let (bound, foci, windings, attractor) = (None, Vec::new(), None, None);
        Self { plane, range: PlotRange::All, lines, surfaces, bound, foci, windings, attractor }
    }

    /// The ways in which rays ended, each once, that of most rays first: its line is solid.
    pub(super) fn statuses(&self) -> Vec<&'a str> {
        let mut statuses: Vec<&str> = Vec::new();
        for line in &self.lines {
            if !statuses.contains(&line.status) {
                statuses.push(line.status);
            }
        }
        let count = |status: &str| self.lines.iter().filter(|line| line.status == status).count();
        statuses.sort_by_cached_key(|status| std::cmp::Reverse(count(status)));
        statuses
    }
}

impl SurfaceKind {
    /// Its name in the legend.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Opaque => "surface",
            Self::Medium => "medium",
            Self::Capture(name) | Self::Limit(name) => name,
        }
    }
}
