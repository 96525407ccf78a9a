//! Plots as SVG or PNG: paths of rays in a plane ([`plot_paths`]), lines in a chart ([`plot_lines`]), and the time of
//! methods against their error ([`plot_precision`]).
//!
//! The extension of the file's name says which format it is. A plot is drawn as SVG; a PNG is that SVG rendered by `resvg` with a font
//! of the program's own, so that both show the same on every system.
//!
//! A series is told from the others by color (of Okabe and Ito's set, which color-blind readers can tell apart), by
//! dashes and by the shape of its markers, so that a plot can also be read in black and white. The legend stands in a
//! column of its own, where it covers nothing. Time and memory grow with the number of points.

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
