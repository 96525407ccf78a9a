//! Ray diagrams: the paths of rays in a plane, with the surfaces that they hit.
//!
//! Everything is projected orthogonally to the plane, at one scale in both directions, and clipped at the axes. The style of a path depends
//! on its termination status; it is drawn as cubic arcs, with an arrow for its direction and a marker at its end. Surfaces are drawn as
//! their outlines in the plane, with a light fill for media. Memory grows with the number of arcs.

mod contents;
mod marks;
mod strokes;
mod view;

use std::path::Path;

pub use self::contents::{CrossSection, PathLine, PathPlot, PlotRange, SurfaceKind};

use self::marks::Labels;
use self::view::View;
use super::canvas::Canvas;
use super::legend::Legend;
use super::sheet::Sheet;
use super::style::Style;
use crate::output::OutputError;

/// The distance from the plane, relative to the extent of the points, above which a note reports a ray.
const OFF_PLANE: f64 = 1e-3;

/// Draws a ray diagram at `path`, as SVG or PNG by its extension.
///
/// # Errors
///
/// Returns [`OutputError::PlotFormat`] for another extension, and an error if the file cannot be drawn or written.
pub fn plot_paths(path: &Path, plot: &PathPlot) -> Result<(), OutputError> {
    let with_bound = legend(plot, plot.bound.is_some());
    let sheet = sheet(plot, &with_bound);
    let view = View::new(plot.plane, &sheet);
    // The legend takes room from the plot, so that the axes follow it.
    let legend = legend(plot, plot.bound.is_some_and(|bound| !strokes::bound(&view, bound).is_empty()));
    let sheet = self::sheet(plot, &legend);
    sheet.save(path, |canvas| draw(canvas, &View::new(plot.plane, &sheet), plot))
}

fn sheet<'l>(plot: &PathPlot, legend: &'l Legend) -> Sheet<'l> {
    let (x, y) = view::axes(plot, legend);
    Sheet { title: "", x, y, legend }
}

fn legend(plot: &PathPlot, bound: bool) -> Legend {
    let labels = plot.labels().into_iter().map(|(label, style)| (label.to_owned(), Style::of(style)));
    let mut entries: Vec<_> = labels.collect();
    let mut kinds: Vec<SurfaceKind> = Vec::new();
    for surface in &plot.surfaces {
        if !kinds.contains(&surface.kind) {
            kinds.push(surface.kind);
            entries.push((surface.kind.name().to_owned(), strokes::look(surface.kind)));
        }
    }
    entries.extend(plot.attractor.is_some().then(|| ("attractor".to_owned(), Style::BEHIND)));
    entries.extend(bound.then(|| ("bound".to_owned(), Style::ASIDE)));
    let points = || plot.lines.iter().flat_map(|line| &line.curve.0).map(|arc| arc[3]);
    let extent = points().map(|p| p.distance(plot.plane.point)).fold(0.0, f64::max);
    let leaves = points().any(|p| plot.plane.height(p).abs() > OFF_PLANE * extent);
    let off = leaves.then(|| "rays leave the plane".to_owned());
    Legend { entries, notes: off.into_iter().chain(marks::notes(plot)).collect() }
}

fn draw(canvas: &mut Canvas, view: &View, plot: &PathPlot) {
    let labels = plot.labels();
    let look = |line: &PathLine| {
        Style::of(labels.iter().find(|(label, _)| *label == line.status).map_or(0, |(_, style)| *style))
    };
    let mut ends = Vec::new();
    canvas.clipped(view.window, |canvas| {
        if let Some(attractor) = &plot.attractor {
            strokes::line(canvas, view, attractor, Style::BEHIND);
        }
        for surface in &plot.surfaces {
            strokes::fill(canvas, view, surface);
        }
        if let Some(bound) = plot.bound {
            Style::ASIDE.stroke(canvas, &strokes::bound(view, bound));
        }
        for surface in &plot.surfaces {
            strokes::outline(canvas, view, surface);
        }
        ends.extend(plot.lines.iter().map(|line| strokes::path(canvas, view, &line.curve, look(line))));
    });
    for line in &plot.lines {
        if let Some(end) = line.curve.end().map(|p| view.at(p)).filter(|at| view.shows(*at)) {
            look(line).mark(canvas, end);
        }
    }
    let mut labels = Labels::new(view);
    marks::foci(canvas, view, plot, &mut labels);
    marks::windings(canvas, view, plot, &ends, &mut labels);
}
