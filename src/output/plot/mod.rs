//! Plots as SVG or PNG: ray diagrams ([`plot_paths`]), charts of lines ([`plot_lines`]), and work–precision diagrams of methods
//! ([`plot_precision`]).
//!
//! The extension of the file selects the format. A plot is drawn as SVG, and a PNG is this SVG rendered by `resvg` with the program's font,
//! so that both look equal on every system.
//!
//! Series differ in color (of the Okabe–Ito palette, which is safe for color-blind readers), dashes and markers, so that a plot can also be
//! read in black and white. The legend is in a separate column, where it covers nothing. Time and memory grow with the number of points.

mod axis;
mod canvas;
mod legend;
mod lines;
mod paths;
mod precision;
mod sheet;
mod style;

pub use lines::{Chart, Series, plot_lines};
pub use paths::{CrossSection, PathLine, PathPlot, PlotRange, SurfaceKind, plot_paths};
pub use precision::{PrecisionPlot, pareto_front, plot_precision};
pub use sheet::check_plot;
