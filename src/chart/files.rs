//! The files of a chart: a table of all points, plots, and a page.

use std::path::{Path, PathBuf};

use super::transfer::{transfer_chart, write_transfer};
use super::{MethodCurve, Point, SceneChart};
use crate::measure::Quantiles;
use crate::output::OutputError;
use crate::output::plot::{PrecisionPlot, Series, plot_lines, plot_precision};
use crate::output::report::{ReportTable, Section};
use crate::output::table::{Field, Row, Table};

/// A point as a line of the CSV.
struct Line<'a>(&'static str, &'a Point);

impl Row for Line<'_> {
    const COLUMNS: &'static [&'static str] = &[
        "method",
        "setting",
        "ns_per_ray",
        "spread",
        "evaluations",
        "steps",
        "rejected",
        "compared",
        "unresolved",
        "wrong",
        "flagged",
        "seen_p95",
        "seen_p99",
        "angle_median",
        "angle_p95",
        "angle_p99",
        "angle_max",
        "position_median",
        "position_p95",
        "position_p99",
        "position_max",
        "tau_p95",
        "light_median",
        "light_p95",
        "light_p99",
        "light_max",
        "drift_p95",
        "image_rms",
    ];

    fn fields(&self) -> Vec<Field> {
        let Self(name, point) = self;
        let found = &point.found;
        let light = |of: fn(&Quantiles) -> f64| found.light.as_ref().map_or(f64::NAN, of);
        let numbers = [
            point.setting,
            1e9 * point.time,
            point.spread,
            point.evaluations,
            point.steps,
            point.rejected,
            found.rays as f64,
            found.unresolved as f64,
            found.wrong as f64,
            found.flagged as f64,
            found.seen.p95,
            found.seen.p99,
            found.angle.median,
            found.angle.p95,
            found.angle.p99,
            found.angle.max,
            found.position.median,
            found.position.p95,
            found.position.p99,
            found.position.max,
            found.tau.p95,
            light(|light| light.median),
            light(|light| light.p95),
            light(|light| light.p99),
            light(|light| light.max),
            point.drifts.iter().map(|(_, drift)| *drift).reduce(f64::max).unwrap_or(f64::NAN),
            point.image,
        ];
        [Field::Word(name)].into_iter().chain(numbers.map(Field::Measured)).collect()
    }
}

/// A function that returns the cost of a ray at a setting.
type Cost = fn(&Point) -> f64;

/// Writes `SCENE.csv`, and `SCENE_time`, `SCENE_evaluations` and the drift of each constant of motion as SVG and PNG into `folder`, for a
/// scene with `[radiation]` also `SCENE_transfer`, and returns the page's section on them.
///
/// # Errors
///
/// Returns an error if a file cannot be written.
pub fn write_chart(folder: &Path, chart: &SceneChart) -> Result<Section, OutputError> {
    let file = |end: &str| folder.join(format!("{}{end}", chart.scene));
    let mut table = Table::create::<Line>(&file(".csv"))?;
    for curve in &chart.curves {
        for point in &curve.points {
            table.write(&Line(curve.name, point))?;
        }
    }
    table.finish()?;
    let plots: [(&str, &str, Cost); 2] = [
        ("time", "time per ray, advance passes (ns)", |point| 1e9 * point.time),
        ("evaluations", "derivative evaluations per ray", |point| point.evaluations),
    ];
    let mut images = Vec::new();
    for (name, label, cost) in plots {
        let plot = plot(chart, label, cost);
        for format in ["svg", "png"] {
            plot_precision(&file(&format!("_{name}.{format}")), &plot)?;
        }
        images.push((
            PathBuf::from(format!("{}_{name}.svg", chart.scene)),
            format!("{}: error against {label}", chart.scene),
        ));
    }
    if !chart.transfer.is_empty() {
        write_transfer(&file("_transfer.csv"), &chart.transfer)?;
        for format in ["svg", "png"] {
            plot_lines(&file(&format!("_transfer.{format}")), &transfer_chart(&chart.scene, &chart.transfer))?;
        }
        images.push((
            PathBuf::from(format!("{}_transfer.svg", chart.scene)),
            format!("{}: tolerance of the radiation against error", chart.scene),
        ));
    }
    for name in kept(chart) {
        let lower = name.to_lowercase();
        let words: Vec<&str> =
            lower.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty()).collect();
        let slug = words.join("_");
        for format in ["svg", "png"] {
            plot_precision(&file(&format!("_drift_{slug}.{format}")), &drift_plot(chart, name))?;
        }
        images.push((
            PathBuf::from(format!("{}_drift_{slug}.svg", chart.scene)),
            format!("{}: steps against drift of {name}", chart.scene),
        ));
    }
    Ok(section(chart, images))
}

/// Returns the constants of motion of the scene's law.
fn kept(chart: &SceneChart) -> Vec<&'static str> {
    let mut names = Vec::new();
    for (name, _) in chart.curves.iter().flat_map(|curve| &curve.points).flat_map(|point| &point.drifts) {
        if !names.contains(name) {
            names.push(*name);
        }
    }
    names
}

fn drift_plot(chart: &SceneChart, name: &str) -> PrecisionPlot {
    let point = |point: &Point| {
        let drift = point.drifts.iter().find(|(own, _)| *own == name).map_or(f64::NAN, |(_, drift)| *drift);
        [drift, point.steps + point.rejected]
    };
    let curve =
        |curve: &MethodCurve| Series { name: curve.name.to_owned(), points: curve.points.iter().map(point).collect() };
    PrecisionPlot {
        title: format!("{}: {name}", chart.scene),
        x_label: "relative drift, 95th percentile".to_owned(),
        y_label: "steps per ray, including rejected steps".to_owned(),
        curves: chart.curves.iter().map(curve).collect(),
        floor: None,
    }
}

/// Returns an error, or infinity if it is nearly half a turn, which means a wrong end.
fn known(error: f64) -> f64 {
    if error < 3.0 { error } else { f64::INFINITY }
}

fn plot(chart: &SceneChart, label: &str, cost: Cost) -> PrecisionPlot {
    let curve = |curve: &MethodCurve| Series {
        name: curve.name.to_owned(),
        points: curve.points.iter().map(|point| [known(chart.error(point)), cost(point)]).collect(),
    };
    PrecisionPlot {
        title: chart.scene.clone(),
        x_label: format!("{}, 95th percentile", chart.judged.label()),
        y_label: label.to_owned(),
        curves: chart.curves.iter().map(curve).collect(),
        floor: Some(chart.floor()).filter(|floor| floor.is_finite()),
    }
}

/// The errors of the table of the fastest methods.
const ERRORS: [f64; 5] = [1e-2, 1e-3, 1e-4, 1e-5, 1e-6];

/// Returns the fastest method at each error, as header and rows.
#[must_use]
pub fn fastest_table(chart: &SceneChart) -> (Vec<String>, Vec<Vec<String>>) {
    let header = [&format!("{}, 95 %", chart.judged.label()), "fastest", "ns per ray", "evaluations", "wrong ends"]
        .map(str::to_owned)
        .to_vec();
    let row = |error: f64| match chart.fastest(error) {
        Some((_, point)) => vec![
            format!("{error:.0e}"),
            point.words.clone(),
            format!("{:.0}", 1e9 * point.time),
            format!("{:.0}", point.evaluations),
            point.found.wrong.to_string(),
        ],
        None => vec![format!("{error:.0e}"), "not reached".to_owned()],
    };
    (header, ERRORS.into_iter().map(row).collect())
}

fn section(chart: &SceneChart, images: Vec<(PathBuf, String)>) -> Section {
    let [compared, unresolved] = chart.compared;
    let (header, rows) = fastest_table(chart);
    let intro = format!(
        "Times are medians over {} rays. Errors are those of {compared} rays relative to a 64-bit reference \
         solution; {unresolved} more rays have an unresolved end. The smallest error of any method is \
         {:.1e} {}.",
        chart.rays,
        chart.floor(),
        chart.judged.unit(),
    );
    let caption = "The fastest method".to_owned();
    Section {
        title: chart.scene.clone(),
        intro: vec![intro],
        images,
        tables: vec![ReportTable { caption, header, rows }],
    }
}
