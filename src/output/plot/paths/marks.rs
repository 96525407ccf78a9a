//! Markers of foci and winding numbers, with labels that do not overlap.

use std::f64::consts::FRAC_PI_4;

use kurbo::{Point, Rect, Shape, Size, Vec2};

use super::contents::{PathLine, PathPlot};
use super::view::View;
use crate::output::plot::canvas::{Align, Canvas, Fill, TEXT_SIZE, text_width};
use crate::output::plot::style::Style;

/// The distance from a marker to its label, in pixels.
const GAP: f64 = 20.0;
/// The height of a label relative to the size of its text.
const HEIGHT: f64 = 1.2;
/// The translucent background of a label.
const VEIL: Fill = Fill("white", 0.8);
/// The fraction of the paths' extent below which coordinates count as zero.
const ROUNDING: f64 = 1e-6;
/// The directions in which a label is tried, in eighths of a turn.
const AROUND: [f64; 8] = [0.0, 1.0, -1.0, 2.0, -2.0, 3.0, -3.0, 4.0];
const AHEAD: [f64; 3] = [0.0, 1.0, -1.0];
/// The first direction for a focus's label: up and right.
const FOCUS_LABEL: Vec2 = Vec2::new(0.8, -0.6);
/// The number of positions along a path where its label is tried.
const BACK: u32 = 4;

/// The occupied and available positions of labels.
pub(super) struct Labels {
    taken: Vec<Rect>,
    room: Rect,
}

impl Labels {
    pub fn new(view: &View) -> Self {
        Self { taken: Vec::new(), room: view.window }
    }

    /// Writes a label at the first free position, or not at all if there is none.
    fn put(&mut self, canvas: &mut Canvas, text: &str, places: impl IntoIterator<Item = Point>) {
        let fits = |label: &Rect| {
            self.room.contains_rect(*label) && !self.taken.iter().any(|taken| taken.intersect(*label).area() > 0.0)
        };
        let labels = places.into_iter().map(|middle| Rect::from_center_size(middle, size(text)));
        let Some(label) = labels.into_iter().find(fits) else { return };
        self.taken.push(label);
        canvas.draw(&label.to_path(0.1), Some(VEIL), None);
        canvas.write(text, label.center(), Align::Middle);
    }

    /// Reserves the area of a marker.
    fn keep_off(&mut self, at: Point) {
        self.taken.push(Rect::from_center_size(at, Size::new(GAP, GAP)));
    }
}

/// Returns the legend's lines about foci and winding numbers.
pub(super) fn notes(plot: &PathPlot) -> Vec<String> {
    let points = plot.lines.iter().flat_map(|line| &line.curve.0).map(|arc| arc[3]);
    let least = ROUNDING * points.map(|p| p.distance(plot.plane.point)).fold(0.0, f64::max);
    let rounded = |value: f64| short(if value.abs() < least { 0.0 } else { value });
    let foci = plot.foci.iter().enumerate().flat_map(|(i, focus)| {
        let [x, y] = plot.plane.flat(focus.place).map(rounded);
        let virtually = if focus.real { "" } else { " (continued)" };
        [format!("{} [{x}, {y}]{virtually}", focus_name(i)), format!("spread {}", short(focus.spread))]
    });
    let about = plot.windings.as_ref().map(|(about, _)| {
        let [x, y] = plot.plane.flat(*about).map(rounded);
        format!("turns around [{x}, {y}]")
    });
    foci.chain(about).collect()
}

/// Marks the foci of bundles.
pub(super) fn foci(canvas: &mut Canvas, view: &View, plot: &PathPlot, labels: &mut Labels) {
    let places: Vec<_> =
        plot.foci.iter().map(|focus| Some(view.at(focus.place)).filter(|at| view.shows(*at))).collect();
    for at in places.iter().flatten() {
        labels.keep_off(*at);
        Style::FOCUS.mark(canvas, *at);
    }
    for (i, at) in places.iter().enumerate() {
        if let Some(at) = at {
            let name = focus_name(i);
            labels.put(canvas, &name, beside(&name, *at, FOCUS_LABEL, &AROUND));
        }
    }
}

/// Marks the center of winding numbers, and labels each path where it was last visible.
pub(super) fn windings(
    canvas: &mut Canvas,
    view: &View,
    plot: &PathPlot,
    ends: &[Option<[Point; 2]>],
    labels: &mut Labels,
) {
    let Some((about, turns)) = &plot.windings else { return };
    let about = view.at(*about);
    if view.shows(about) {
        labels.keep_off(about);
        Style::CENTER.mark(canvas, about);
    }
    let ends_at = |line: &PathLine, at: Point| line.curve.end().is_some_and(|p| view.at(p).distance(at) < 1.0);
    let seen =
        || ends.iter().zip(turns).zip(&plot.lines).filter_map(|((end, turns), line)| Some(((*end)?, *turns, line)));
    for ([at, _], ..) in seen().filter(|([at, _], _, line)| ends_at(line, *at)) {
        labels.keep_off(at);
    }
    for ([at, ahead], turns, line) in seen() {
        let text = format!("{turns:.2}");
        let direction = ahead - at;
        if ends_at(line, at) {
            labels.put(canvas, &text, beside(&text, at, direction, &AHEAD));
        } else {
            // The label is on the path where it leaves the window, or further back.
            let reach = |k: u32| at - direction * (GAP + f64::from(k) * size(&text).to_vec2().hypot() / 2.0);
            labels.put(canvas, &text, (1..=BACK).map(reach));
        }
    }
}

/// Returns positions of the center of a label next to a point, at angles in eighths of a turn from `towards`.
fn beside(text: &str, at: Point, towards: Vec2, eighths: &[f64]) -> impl Iterator<Item = Point> {
    let half = size(text).to_vec2() / 2.0;
    let sides = eighths.iter().map(move |eighths| towards.rotate_scale(Vec2::from_angle(eighths * FRAC_PI_4)));
    sides.map(move |side| at + side * GAP + Vec2::new(side.x * half.x, side.y * half.y))
}

/// Returns the approximate width and height of a label in pixels.
fn size(text: &str) -> Size {
    Size::new(text_width(text), HEIGHT * TEXT_SIZE)
}

fn focus_name(i: usize) -> String {
    format!("F{}", i + 1)
}

/// Formats a number to four digits, with an exponent if this is shorter.
fn short(value: f64) -> String {
    let tidy: f64 = format!("{value:.3e}").parse().unwrap_or(value);
    if tidy == 0.0 || (1e-3..1e5).contains(&tidy.abs()) { format!("{}", tidy + 0.0) } else { format!("{tidy:e}") }
}
