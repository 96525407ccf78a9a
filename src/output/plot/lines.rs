//! Lines in a chart with linear or logarithmic axes.

use std::path::Path;

use super::{
    Area, Drawn, OutputError,
    axis::{Axis, place},
    frame,
    legend::Legend,
    save,
    style::{Look, Place},
};

/// Markers on a line, at most: more would hide its dashes.
const MARKS: usize = 20;

/// A chart: what it is called, its axes and its lines.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Chart {
    /// What stands above; may be empty.
    pub title: String,
    /// What x is, with its unit.
    pub x_label: String,
    /// What y is, with its unit.
    pub y_label: String,
    /// Whether x is logarithmic.
    pub log_x: bool,
    /// Whether y is logarithmic.
    pub log_y: bool,
    /// The lines, in the order of the legend.
    pub series: Vec<Series>,
}

/// A line of a chart.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Series {
    /// Its name in the legend.
    pub name: String,
    /// Its points `[x, y]` in the order they are joined. Where one is not finite, or not positive on a logarithmic
    /// axis, the line is broken, and a note under the legend counts it.
    pub points: Vec<[f64; 2]>,
}

/// Draws a chart at `path`, as SVG or PNG by its extension.
pub fn plot_lines(path: &Path, chart: &Chart) -> Result<(), OutputError> {
    let placed: Vec<Vec<_>> =
        chart.series.iter().map(|s| s.points.iter().map(|p| place_on(chart, *p)).collect()).collect();
    let all = || placed.iter().flatten().flatten();
    let x = Axis::around(&chart.x_label, chart.log_x, all().map(|p| p[0]));
    let y = Axis::around(&chart.y_label, chart.log_y, all().map(|p| p[1]));
    let missing = placed.iter().flatten().filter(|p| p.is_none()).count();
    let legend = Legend::of(chart.series.iter().map(|s| &s.name), missing);
    save(path, &legend, |canvas, area| {
        let plot = frame(area, &chart.title, &x, &y)?;
        for (i, line) in placed.iter().enumerate() {
            let on_canvas: Vec<_> = line.iter().map(|p| p.map(|p| plot.backend_coord(&p.into()))).collect();
            draw(canvas, &on_canvas, Look::of(i))?;
        }
        Ok(())
    })
}

/// A point in plot coordinates, if it has any.
fn place_on(chart: &Chart, [x, y]: [f64; 2]) -> Option<[f64; 2]> {
    Some([place(x, chart.log_x)?, place(y, chart.log_y)?])
}

fn draw(canvas: &Area, line: &[Option<Place>], look: Look) -> Drawn<()> {
    for part in line.split(Option::is_none) {
        look.stroke(canvas, part.iter().copied().flatten().collect())?;
    }
    let every = line.len().div_ceil(MARKS).max(1);
    line.iter().step_by(every).flatten().try_for_each(|at| look.mark(canvas, *at))
}
