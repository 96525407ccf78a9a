//! Plots as SVG or PNG: paths of rays in a plane ([`plot_paths`]), lines in a chart ([`plot_lines`]), and the time of
//! methods against their error ([`plot_precision`]).
//!
//! The extension of the file's name says which format it is. Both are drawn from the same shapes, and a PNG needs no
//! font of the system.
//!
//! A series is told from the others by colour (of Okabe and Ito's set, which colour-blind readers can tell apart), by
//! dashes and by the shape of its markers, so that a plot can also be read in black and white. The legend stands in a
//! column of its own, where it covers nothing. The canvas is large because the drawing library rounds to whole
//! pixels. Time and memory grow with the number of points.

mod axis;
mod figure;
mod glyphs;
mod legend;
mod lines;
mod paper;
mod paths;
mod precision;
mod raster;
mod style;
mod vector;

use std::{fmt::Display, io::Write, path::Path};

use plotters::{
    chart::ChartContext,
    coord::Shift,
    prelude::{Cartesian2d, ChartBuilder, DrawingArea, IntoDrawingArea, TRANSPARENT, Text, WHITE},
    style::{BLACK, IntoFont, TextStyle, text_anchor::Pos},
};

use self::{
    axis::Axis,
    legend::Legend,
    paper::{Format, Paper},
    style::Place,
};
use super::{AtomicFile, OutputError};

pub use lines::{Chart, Series, plot_lines};
pub use paths::{Frame, PathLine, PathPlot, Surface, SurfaceKind, plot_paths};
pub use precision::{PrecisionPlot, pareto_front, plot_precision};

/// Width and height of a plot in pixels, the legend included.
const CANVAS: (u32, u32) = (1600, 1200);
/// Room for the numbers and name of the x axis below the plot, and of the y axis beside it.
const LABEL_AREA: (u32, u32) = (90, 140);
/// Empty room around the plot.
const MARGIN: u32 = 30;
const FONT: &str = "sans-serif";
const LABEL_SIZE: u32 = 28;
const TITLE_SIZE: u32 = 36;

type Area<'a> = DrawingArea<Paper<'a>, Shift>;
type Plot<'a> = ChartContext<'a, Paper<'a>, Cartesian2d<Axis, Axis>>;
/// A result whose error is in words, because the library's own types hold those of its backend.
type Drawn<T> = Result<T, String>;

fn words(error: impl Display) -> String {
    error.to_string()
}

/// Makes sure that a plot can be written at `path`, before the work that it will show.
pub fn check_plot(path: &Path) -> Result<(), OutputError> {
    Format::of(path)?;
    AtomicFile::create(path).map(drop)
}

/// Draws on a white canvas with a legend, and writes the file.
///
/// `draw` is given the whole canvas and the part of it that is left of the legend.
fn save(path: &Path, legend: &Legend, draw: impl FnOnce(&Area, &Area) -> Drawn<()>) -> Result<(), OutputError> {
    let format = Format::of(path)?;
    let mut file = AtomicFile::create(path)?;
    let bytes = format
        .paint(|paper| paint(paper, legend, draw))
        .map_err(|problem| OutputError::Plot { path: path.to_owned(), problem })?;
    file.write_all(&bytes).map_err(|e| file.failed(e))?;
    file.finish()
}

fn paint(paper: Paper, legend: &Legend, draw: impl FnOnce(&Area, &Area) -> Drawn<()>) -> Drawn<()> {
    let canvas = paper.into_drawing_area();
    canvas.fill(&WHITE).map_err(words)?;
    let (plot, _) = canvas.split_horizontally(CANVAS.0 - legend.width());
    draw(&canvas, &plot)?;
    legend.draw(&canvas)?;
    canvas.present().map_err(words)
}

/// Writes a line of text about a place of the canvas.
fn write(canvas: &Area, line: &str, at: Place, anchor: Pos) -> Drawn<()> {
    let style = TextStyle::from((FONT, LABEL_SIZE).into_font()).color(&BLACK).pos(anchor);
    canvas.draw(&Text::new(line, at, style)).map_err(words)
}

/// Width and height in pixels that are left for the data beside a legend and under no title.
fn data_size(legend: &Legend) -> (f64, f64) {
    let width = CANVAS.0 - legend.width() - LABEL_AREA.1 - 2 * MARGIN;
    let height = CANVAS.1 - LABEL_AREA.0 - 2 * MARGIN;
    (f64::from(width), f64::from(height))
}

/// The axes of a plot, with a title above unless it is empty.
fn frame<'a>(area: &Area<'a>, title: &str, x: &Axis, y: &Axis) -> Drawn<Plot<'a>> {
    let mut builder = ChartBuilder::on(area);
    builder.margin(MARGIN).x_label_area_size(LABEL_AREA.0).y_label_area_size(LABEL_AREA.1);
    if !title.is_empty() {
        builder.caption(title, (FONT, TITLE_SIZE));
    }
    let mut plot = builder.build_cartesian_2d(x.clone(), y.clone()).map_err(words)?;
    plot.configure_mesh()
        .x_desc(&x.label)
        .y_desc(&y.label)
        .label_style((FONT, LABEL_SIZE))
        .axis_desc_style((FONT, LABEL_SIZE))
        .light_line_style(TRANSPARENT)
        .draw()
        .map_err(words)?;
    Ok(plot)
}
