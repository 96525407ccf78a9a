//! The contents of a ray diagram.

use glam::DVec3;

use crate::measure::{Curve, Focus};
use crate::render::Status;
use crate::scene::{CutPlane, Outline};

/// The statuses in the order of their styles; the line of the first is solid.
const STYLED: [Status; 8] = [
    Status::Escaped,
    Status::Captured,
    Status::Hit,
    Status::Ended,
    Status::Exhausted,
    Status::Stalled,
    Status::Failed,
    Status::Cut,
];

/// The path of one ray.
#[derive(Debug, Clone, PartialEq)]
pub struct PathLine<'a> {
    /// The path in scene coordinates.
    pub curve: Curve,
    /// The termination status of the ray, or another label.
    pub status: &'a str,
}

/// The kind of a surface in a cross section.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SurfaceKind {
    /// An opaque surface of an object.
    Opaque,
    /// The surface of a transparent object.
    Medium,
    /// A capture sphere of the law, by its name.
    Capture(&'static str),
    /// Another sphere of the law, by its name.
    Limit(&'static str),
}

/// The cross section of a surface with the plane.
#[derive(Debug, Clone, PartialEq)]
pub struct CrossSection {
    /// The kind of the surface.
    pub kind: SurfaceKind,
    /// The outlines of the cross section.
    pub outlines: Vec<Outline>,
}

/// The visible range of the plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PlotRange {
    /// All paths and the bounding sphere.
    All,
    /// The bounding box of the surfaces, enlarged by half; everything if there are no surfaces.
    Objects,
    /// At least [left, right, bottom, top] in scene units; both axes have one scale.
    Given([f64; 4]),
}

/// A ray diagram.
#[derive(Debug, Clone, PartialEq)]
pub struct PathPlot<'a> {
    /// The plane of the diagram.
    pub plane: CutPlane,
    /// The visible range.
    pub range: PlotRange,
    /// The paths.
    pub lines: Vec<PathLine<'a>>,
    /// The cross sections of surfaces.
    pub surfaces: Vec<CrossSection>,
    /// The center and radius of the bounding sphere, if it is visible.
    pub bound: Option<(DVec3, f64)>,
    /// The foci to mark, with their spread.
    pub foci: Vec<Focus>,
    /// A point to mark, with the winding number of each path around it, in turns.
    pub windings: Option<(DVec3, Vec<f64>)>,
    /// The attractor of a flow, drawn behind everything else.
    pub attractor: Option<Curve>,
}

impl<'a> PathPlot<'a> {
    /// Creates a diagram of paths alone, with all of them visible.
    #[must_use]
    pub fn new(plane: CutPlane, lines: Vec<PathLine<'a>>) -> Self {
        let surfaces = Vec::new();
        let (bound, foci, windings, attractor) = (None, Vec::new(), None, None);
        Self { plane, range: PlotRange::All, lines, surfaces, bound, foci, windings, attractor }
    }

    /// Returns the labels of the paths, each once, with the index of its style. A status has the same style in all diagrams; other labels
    /// are numbered in order of appearance.
    pub(super) fn labels(&self) -> Vec<(&'a str, usize)> {
        let mut labels: Vec<(&str, usize)> = Vec::new();
        for line in &self.lines {
            if labels.iter().all(|(label, _)| *label != line.status) {
                let known = STYLED.iter().position(|status| status.name() == line.status);
                labels.push((line.status, known.unwrap_or(labels.len())));
            }
        }
        labels.sort_by_key(|(_, style)| *style);
        labels
    }
}

impl SurfaceKind {
    /// Returns the name in the legend.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Opaque => "surface",
            Self::Medium => "medium",
            Self::Capture(name) | Self::Limit(name) => name,
        }
    }
}
