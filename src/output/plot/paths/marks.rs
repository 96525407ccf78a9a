//! Foci and windings: markers, and labels that do not cover each other.

use std::f64::consts::FRAC_PI_4;

use glam::DVec2;
use plotters::prelude::Rectangle;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color, WHITE};

use super::strokes::place;
use super::view::View;
use super::{PathLine, PathPlot, Plot};
use crate::output::plot::legend::text_width;
use crate::output::plot::style::{Look, Place};
use crate::output::plot::{Area, Drawn, LABEL_SIZE, words, write};

/// From a marker to its label, in pixels.
const GAP: f64 = 20.0;
/// How much of what is under a label shines through.
const VEIL: f64 = 0.8;
/// Coordinates below this part of the paths' extent are roundings of zero.
const ROUNDING: f64 = 1e-6;
/// Directions in which a label is tried, in eighths of a turn.
const AROUND: [f64; 8] = [0.0, 1.0, -1.0, 2.0, -2.0, 3.0, -3.0, 4.0];
const AHEAD: [f64; 3] = [0.0, 1.0, -1.0];
/// The first direction of a focus's label: up to the right.
const FOCUS_LABEL: DVec2 = DVec2::new(0.8, -0.6);
/// Places along a path where its label is tried.
const BACK: u32 = 4;

/// Where there are labels already, and where there may be some.
pub(super) struct Labels {
    taken: Vec<[i32; 4]>,
    room: [i32; 4],
}

impl Labels {
    pub fn new(axes: &Plot) -> Self {
        let (x, y) = axes.plotting_area().get_pixel_range();
        Self { taken: Vec::new(), room: [x.start, y.start, x.end, y.end] }
    }

    /// Writes a label at the first of some places where there is room; nowhere if there is none.
    fn put(&mut self, canvas: &Area, text: &str, places: impl IntoIterator<Item = DVec2>) -> Drawn<()> {
        let half = half_size(text);
        let boxed = |middle: DVec2| {
            let [low, high] = [place(middle - half), place(middle + half)];
            (middle, [low.0, low.1, high.0, high.1])
        };
        let free = |b: &[i32; 4]| {
            let within = b[0] >= self.room[0] && b[1] >= self.room[1] && b[2] <= self.room[2] && b[3] <= self.room[3];
            within && !self.taken.iter().any(|t| b[0] < t[2] && t[0] < b[2] && b[1] < t[3] && t[1] < b[3])
        };
        let Some((middle, b)) = places.into_iter().map(boxed).find(|(_, b)| free(b)) else { return Ok(()) };
        self.taken.push(b);
        let veil = Rectangle::new([(b[0], b[1]), (b[2], b[3])], WHITE.mix(VEIL).filled());
        canvas.draw(&veil).map_err(words)?;
        write(canvas, text, place(middle), Pos { h_pos: HPos::Center, v_pos: VPos::Center })
    }

    /// Keeps labels off a place.
    fn keep_off(&mut self, (x, y): Place, radius: i32) {
        self.taken.push([x - radius, y - radius, x + radius, y + radius]);
    }
}

/// What the legend says of foci and windings.
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
        format!("turns about [{x}, {y}]")
    });
    foci.chain(about).collect()
}

/// Marks where bundles come together.
pub(super) fn foci(canvas: &Area, view: &View, plot: &PathPlot, labels: &mut Labels) -> Drawn<()> {
    let visible = |p: &DVec2| view.window.contains(*p);
    let places: Vec<_> = plot.foci.iter().map(|focus| Some(view.flat(focus.place)).filter(visible)).collect();
    for at in places.iter().flatten().map(|p| place(view.pixel(*p))) {
        labels.keep_off(at, GAP as i32 / 2);
        Look::focus().mark(canvas, at)?;
    }
    for (i, at) in places.iter().enumerate() {
        if let Some(at) = at {
            let name = focus_name(i);
            labels.put(canvas, &name, beside(&name, view.pixel(*at), FOCUS_LABEL, &AROUND))?;
        }
    }
    Ok(())
}

/// Marks the point that paths wind about, and writes the turns beside where each is last seen.
pub(super) fn windings(
    canvas: &Area,
    view: &View,
    plot: &PathPlot,
    ends: &[Option<[DVec2; 2]>],
    labels: &mut Labels,
) -> Drawn<()> {
    let Some((about, turns)) = &plot.windings else { return Ok(()) };
    let about = view.flat(*about);
    if view.window.contains(about) {
        let at = place(view.pixel(about));
        labels.keep_off(at, GAP as i32 / 2);
        Look::center().mark(canvas, at)?;
    }
    let ends_at =
        |line: &PathLine, at: DVec2| line.curve.end().is_some_and(|p| view.pixel(view.flat(p)).distance(at) < 1.0);
    let seen =
        || ends.iter().zip(turns).zip(&plot.lines).filter_map(|((end, turns), line)| Some(((*end)?, *turns, line)));
    for ([at, _], ..) in seen().filter(|([at, _], _, line)| ends_at(line, *at)) {
        labels.keep_off(place(at), GAP as i32 / 2);
    }
    for ([at, direction], turns, line) in seen() {
        let text = format!("{turns:.2}");
        if ends_at(line, at) {
            labels.put(canvas, &text, beside(&text, at, direction, &AHEAD))?;
        } else {
            // On the path where it leaves the frame, or further back.
            let reach = |k: u32| at - direction * (GAP + f64::from(k) * half_size(&text).length());
            labels.put(canvas, &text, (1..=BACK).map(reach))?;
        }
    }
    Ok(())
}

/// Places for the middle of a label beside another place, at angles in eighths of a turn from `towards`.
fn beside(text: &str, at: DVec2, towards: DVec2, eighths: &[f64]) -> impl Iterator<Item = DVec2> {
    let half = half_size(text);
    let sides = eighths.iter().map(move |eighths| DVec2::from_angle(eighths * FRAC_PI_4).rotate(towards));
    sides.map(move |side| at + side * GAP + side * half)
}

/// Half the width and height of a label in pixels, about.
fn half_size(text: &str) -> DVec2 {
    DVec2::new(f64::from(text_width(text)), f64::from(LABEL_SIZE)) / 2.0
}

fn focus_name(i: usize) -> String {
    format!("F{}", i + 1)
}

/// Four digits, with an exponent where that is shorter.
fn short(value: f64) -> String {
    let tidy: f64 = format!("{value:.3e}").parse().unwrap_or(value);
    if tidy == 0.0 || (1e-3..1e5).contains(&tidy.abs()) { format!("{}", tidy + 0.0) } else { format!("{tidy:e}") }
}
