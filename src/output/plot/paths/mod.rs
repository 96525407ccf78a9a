//! Ray diagrams: paths of rays in a plane, with what they meet.
//!
//! Everything is shown as its shadow on the plane, at one scale in both directions, and cut off at the frame. A path is drawn by how
//! its ray ended, as cubic arcs, with an arrow for its direction and a marker at its end; surfaces as the lines in which they cross
//! the plane, those of media lightly filled. Memory grows with the number of arcs.

mod clip;
mod marks;
mod strokes;
mod view;

use std::path::Path;

use glam::{DVec2, DVec3};

use self::marks::Labels;
use self::view::View;
use super::{Area, Drawn, OutputError, Plot, axis::Axis, frame, legend::Legend, save, style::Look};
use crate::measure::{Curve, Focus};
use crate::scene::{CORNERS, CutPlane, Outline};

/// Rays whose points are off the plane by more than this part of their extent are said to be.
const OFF_PLANE: f64 = 1e-3;

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
    /// A sphere of the law, by its name.
    Landmark(&'static str),
}

/// Something that crosses the plane.
#[derive(Debug, Clone, PartialEq)]
pub struct Surface {
    /// What it is.
    pub kind: SurfaceKind,
    /// Where it crosses.
    pub outlines: Vec<Outline>,
}

/// Which part of the plane is shown.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Frame {
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
    pub frame: Frame,
    /// The paths.
    pub lines: Vec<PathLine<'a>>,
    /// What crosses the plane.
    pub surfaces: Vec<Surface>,
    /// Centre and radius of the bounding sphere, if it is to be shown.
    pub bound: Option<(DVec3, f64)>,
    /// Places to mark, with their spread.
    pub foci: Vec<Focus>,
    /// A point to mark, and how often each path goes round it, in turns.
    pub windings: Option<(DVec3, Vec<f64>)>,
}

impl<'a> PathPlot<'a> {
    /// Paths alone, all of them.
    #[must_use]
    pub fn new(plane: CutPlane, lines: Vec<PathLine<'a>>) -> Self {
        let surfaces = Vec::new();
        Self { plane, frame: Frame::All, lines, surfaces, bound: None, foci: Vec::new(), windings: None }
    }

    /// The ways in which rays ended, each once, that of most rays first: its line is solid.
    fn statuses(&self) -> Vec<&'a str> {
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

    fn bound_circle(&self) -> Vec<DVec2> {
        let circle = |(center, radius): (DVec3, f64)| {
            let middle = DVec2::from(self.plane.flat(center));
            let angle = |i: u32| std::f64::consts::TAU * f64::from(i) / f64::from(CORNERS);
            (0..=CORNERS).map(|i| middle + radius * DVec2::from_angle(angle(i))).collect()
        };
        self.bound.map(circle).unwrap_or_default()
    }

    fn legend(&self, bound: bool) -> Legend {
        let statuses = self.statuses().into_iter().enumerate().map(|(i, status)| (status.to_owned(), Look::of(i)));
        let mut entries: Vec<_> = statuses.collect();
        let mut kinds: Vec<SurfaceKind> = Vec::new();
        for surface in &self.surfaces {
            if !kinds.contains(&surface.kind) {
                kinds.push(surface.kind);
                entries.push((surface.kind.name().to_owned(), Look::surface(surface.kind)));
            }
        }
        entries.extend(bound.then(|| ("bound".to_owned(), Look::aside())));
        Legend { entries, notes: self.notes() }
    }

    fn notes(&self) -> Vec<String> {
        let points = || self.lines.iter().flat_map(|line| &line.curve.0).map(|arc| arc[3]);
        let extent = points().map(|p| p.distance(self.plane.point)).fold(0.0, f64::max);
        let leaves = points().any(|p| self.plane.height(p).abs() > OFF_PLANE * extent);
        let off = leaves.then(|| "rays leave the plane".to_owned());
        off.into_iter().chain(marks::notes(self)).collect()
    }
}

impl SurfaceKind {
    fn name(self) -> &'static str {
        match self {
            Self::Opaque => "surface",
            Self::Medium => "medium",
            Self::Landmark(name) => name,
        }
    }
}

/// Draws a ray diagram at `path`, as SVG or PNG by its extension.
pub fn plot_paths(path: &Path, plot: &PathPlot) -> Result<(), OutputError> {
    let circle = plot.bound_circle();
    let (x, y) = view::axes(plot, &plot.legend(plot.bound.is_some()));
    let shows = |x: &Axis, y: &Axis| {
        let low = DVec2::new(x.range.start, y.range.start);
        let high = DVec2::new(x.range.end, y.range.end);
        !clip::Window { low, high }.line(&circle).is_empty()
    };
    // The legend takes room from the plot, so that the axes come after it.
    let legend = plot.legend(shows(&x, &y));
    let (x, y) = view::axes(plot, &legend);
    save(path, &legend, |canvas, area| {
        let axes = frame(area, "", &x, &y)?;
        draw(canvas, &axes, plot, &View::new(plot.plane, &axes, &x, &y), &circle)
    })
}

fn draw(canvas: &Area, axes: &Plot, plot: &PathPlot, view: &View, circle: &[DVec2]) -> Drawn<()> {
    for surface in &plot.surfaces {
        strokes::fill(canvas, view, surface)?;
    }
    for part in view.window.line(circle) {
        strokes::line(canvas, view, &part, Look::aside())?;
    }
    for surface in &plot.surfaces {
        strokes::outline(canvas, view, surface)?;
    }
    let statuses = plot.statuses();
    let look = |line: &PathLine| Look::of(statuses.iter().position(|s| *s == line.status).unwrap_or(0));
    let mut ends = Vec::new();
    for line in &plot.lines {
        ends.push(strokes::path(canvas, view, &line.curve, look(line))?);
    }
    for line in &plot.lines {
        let end = line.curve.end().map(|p| view.flat(p)).filter(|p| view.window.contains(*p));
        if let Some(end) = end {
            look(line).mark(canvas, strokes::place(view.pixel(end)))?;
        }
    }
    let mut labels = Labels::new(axes);
    marks::foci(canvas, view, plot, &mut labels)?;
    marks::windings(canvas, view, plot, &ends, &mut labels)
}
