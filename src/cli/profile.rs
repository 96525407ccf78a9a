//! `bentray profile`: the light of a disk as an instrument measures it, as a table and as a plot.

use std::path::{Path, PathBuf};

use clap::Args;

use super::choose_method::{Settled, settle};
use super::decisions::Rays;
use super::frames::Film;
use super::options::{DeviceFlags, SceneOptions, one_of};
use super::render::warn;
use super::{of_scene, paths};
use crate::assets::{Emissivity, FormulaError};
use crate::document::{Dimension, Quantity};
use crate::error::Error;
use crate::measure::profile::{self, Kind, Orders, Point, RadiationSpectrum};
use crate::output::plot::{Chart, Series, check_plot, plot_lines};
use crate::output::table::{Field, Row, Table};
use crate::output::{OutputError, has_extension};
use crate::program::CROSSINGS;
use crate::render::{RenderError, StartUp};
use crate::scene::Scene;

/// Compute a line profile, a light curve or a spectrum of a scene's disk or volumes as seen by its camera, as a table and as a plot
#[derive(Debug, Args)]
pub(super) struct Arguments {
    /// The scene file, or - for standard input
    scene: PathBuf,
    /// The quantity
    #[arg(long, value_parser = one_of(Kind::ALL, Kind::name, Kind::meaning), default_value = Kind::Line.name())]
    of: Kind,
    /// Output file: a table (.csv or .npz; - is standard output) or a plot (.svg or .png); repeatable
    #[arg(short, long, value_name = "FILE", required = true)]
    output: Vec<PathBuf>,
    /// The light that the surface emits, for a line or a light curve: a formula of the radius r, the azimuth phi, the time t and mu, the
    /// cosine of the angle to the surface normal [default: r^-3]
    #[arg(long, value_name = "FORMULA", value_parser = formula)]
    emissivity: Option<Emissivity>,
    /// The first and the last value: of g for a line, of the observer's time for a light curve (required there), or of the frequency in Hz
    /// for a spectrum; with units if you like, such as "1 GHz,1 THz" [default: all light]
    #[arg(long, value_name = "FROM,TO", value_parser = range, allow_negative_numbers = true)]
    range: Option<[Bound; 2]>,
    /// Number of values in the table
    #[arg(long, value_name = "N", default_value_t = 200, value_parser = clap::value_parser!(u32).range(2..=100_000))]
    points: u32,
    /// Use only the light of this object, by its index in the scene file, from 0 (repeatable) [default: all objects]
    #[arg(long, value_name = "INDEX")]
    object: Vec<u32>,
    #[command(flatten)]
    changes: SceneOptions,
    #[command(flatten)]
    device: DeviceFlags,
}

/// A bound of a range.
#[derive(Debug, Clone)]
enum Bound {
    Number(f64),
    Quantity(Quantity),
}

fn formula(text: &str) -> Result<Emissivity, String> {
    text.parse().map_err(|error: FormulaError| {
        let help = if error.help.is_empty() { String::new() } else { format!("; {}", error.help) };
        format!("column {}: {}{help}", text[..error.place.start].chars().count() + 1, error.problem)
    })
}

fn range(text: &str) -> Result<[Bound; 2], String> {
    let bound = |text: &str| {
        let number = text.trim().parse().ok().filter(|number: &f64| number.is_finite()).map(Bound::Number);
        number.or_else(|| Quantity::parse(text).map(Bound::Quantity))
    };
    let read = text.split_once(',').and_then(|(from, to)| Some([bound(from)?, bound(to)?]));
    read.ok_or_else(|| format!("expected two values such as 0.2,1.4, found `{text}`"))
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Error> {
    arguments.device.check()?;
    let kind = arguments.of;
    let opening = arguments.device.open();
    let film = Film::new(&arguments.scene, arguments.changes.overrides()?).on(arguments.device.name());
    let scene = film.load(None)?;
    let range = arguments.range.as_ref().map(|range| resolved(kind, range, &scene)).transpose()?;
    paths::check(arguments.output.iter().map(PathBuf::as_path), &film.inputs())?;
    let objects = Some(arguments.object.as_slice()).filter(|objects| !objects.is_empty());
    if scene.camera.is_none() {
        return Err(of_scene(&arguments.scene, RenderError::NoCamera));
    }
    if let Some(problem) = kind.refuses(range, arguments.emissivity.is_some()) {
        return Err(usage!("{problem}"));
    }
    if let Some(problem) = kind.refuses_scene(&scene, objects) {
        return Err(of_scene(&arguments.scene, problem));
    }
    let (plots, tables): (Vec<&PathBuf>, Vec<&PathBuf>) =
        arguments.output.iter().partition(|path| has_extension(path, "svg") || has_extension(path, "png"));
    plots.iter().try_for_each(|path| check_plot(path))?;
    let radiates = kind == Kind::Spectrum && scene.radiation.is_some();
    let create = |path| if radiates { Table::create::<Radiated>(path) } else { create(kind, path) };
    let tables = tables.into_iter().map(|path| create(path)).collect::<Result<Vec<_>, _>>()?;
    let gpu = opening.finish()?;
    let settings = arguments.device.settings(Vec::new());
    let [width, height] = scene.image.size.map(u64::from);
    let Settled { scene, settings, .. } =
        settle(&gpu, (&film, None), scene, settings, Rays::Camera(width * height), &mut StartUp::default())?;
    if let Some(radiation) = scene.radiation.as_ref().filter(|_| radiates) {
        let count = arguments.points as usize;
        let found = RadiationSpectrum::new(&gpu, (&scene, radiation), &settings, range, count)?;
        tell!("{}", found.totals);
        warn(&found.totals);
        return write_spectrum(found, tables, &plots);
    }
    let (emissions, totals) = profile::emissions(&gpu, &scene, &settings, objects)?;
    tell!("{totals}");
    warn(&totals);
    if emissions.is_empty() {
        return Err(of_scene(
            &arguments.scene,
            "no ray of the camera meets a surface with a redshift: point the camera at a disk",
        ));
    }
    let emissivity =
        arguments.emissivity.clone().map_or_else(|| formula("r^-3").map_err(|problem| usage!("{problem}")), Ok)?;
    let points = profile::measure(kind, &scene, &emissions, &emissivity, range, arguments.points as usize)
        .map_err(|error| usage!("--emissivity: {error}"))?;
    if kind == Kind::Line {
        tell_line(&points);
    }
    for mut table in tables {
        // All rows have the same fields; only the header depends on the kind.
        points.iter().try_for_each(|point| table.write(&Named::<0>(*point)))?;
        table.finish()?;
    }
    let chart = chart(kind, &points, &scene);
    Ok(plots.into_iter().try_for_each(|path| plot_lines(path, &chart))?)
}

/// Writes a spectrum of volumes.
fn write_spectrum(found: RadiationSpectrum, tables: Vec<Table>, plots: &[&PathBuf]) -> Result<(), Error> {
    for mut table in tables {
        found.points.iter().try_for_each(|point| table.write(&Radiated(*point)))?;
        table.finish()?;
    }
    let x = if found.in_hertz { "frequency (Hz)" } else { "frequency (ν₀)" };
    let y = if found.in_janskys { "flux (Jy)" } else { "flux (intensity × scene units²)" };
    let chart = Chart::logarithmic("", [x, y], vec![Series::new("all", found.points)]);
    Ok(plots.iter().try_for_each(|path| plot_lines(path, &chart))?)
}

/// Returns a range in the units of the table.
fn resolved(kind: Kind, range: &[Bound; 2], scene: &Scene) -> Result<[f64; 2], Error> {
    let wanted = match kind {
        Kind::Line => None,
        Kind::LightCurve => Some(Dimension::Time),
        Kind::Spectrum => Some(Dimension::Frequency),
    };
    let value = |bound: &Bound| match bound {
        Bound::Number(number) => Ok(*number),
        Bound::Quantity(read) if Some(read.dimension) != wanted => {
            let wanted = wanted.map_or("a number without a unit", Dimension::name);
            Err(usage!("--range: `{}` is {}, but {wanted} is required here", read.text.trim(), read.dimension.name()))
        }
        Bound::Quantity(read) if kind == Kind::LightCurve => match scene.units.and_then(|units| units.time()) {
            Some(unit) => Ok(read.si / unit),
            None => Err(usage!(
                "--range: `{}` requires the scale of the scene: add [units] with a mass or a length",
                read.text.trim()
            )),
        },
        Bound::Quantity(read) if scene.radiation.as_ref().is_some_and(|radiation| radiation.reference.is_none()) => {
            Err(usage!("--range: `{}` requires a scale: give radiation.frequencies units", read.text.trim()))
        }
        Bound::Quantity(read) => Ok(read.si),
    };
    Ok([value(&range[0])?, value(&range[1])?])
}

fn create(kind: Kind, path: &Path) -> Result<Table, OutputError> {
    match kind {
        Kind::Line => Table::create::<Named<0>>(path),
        Kind::LightCurve => Table::create::<Named<1>>(path),
        Kind::Spectrum => Table::create::<Named<2>>(path),
    }
}

fn chart(kind: Kind, points: &[Point], scene: &Scene) -> Chart {
    let of = |value: &dyn Fn(&Orders) -> f64| points.iter().map(|(x, orders)| [*x, value(orders)]).collect();
    let mut series = vec![Series::new("all", of(&|orders| orders.iter().sum()))];
    let is_seen = |k: &usize| points.iter().any(|(_, orders)| orders[*k] > 0.0);
    let seen: Vec<usize> = (0..CROSSINGS).filter(is_seen).collect();
    if seen.len() > 1 {
        series.extend(seen.into_iter().map(|k| Series::new(format!("order {k}"), of(&|orders| orders[k]))));
    }
    match kind {
        Kind::Line => Chart::linear("", ["redshift factor g", "flux per g (emissivity × sr)"], series),
        Kind::LightCurve => Chart::linear("", [&time_label(scene), "flux (emissivity × sr)"], series),
        Kind::Spectrum => Chart::logarithmic("", ["frequency (Hz)", "flux (Jy)"], series),
    }
}

/// A row of the table of a spectrum of volumes.
struct Radiated([f64; 2]);

impl Row for Radiated {
    const COLUMNS: &'static [&'static str] = &["frequency", "flux"];

    fn fields(&self) -> Vec<Field> {
        self.0.map(|value| Field::Number(Some(value))).to_vec()
    }
}

/// Prints the flux of a line and its mean.
fn tell_line(points: &[Point]) {
    let per_bin = points[1].0 - points[0].0;
    let sum = |of: &dyn Fn(f64) -> f64| {
        per_bin * points.iter().map(|(g, orders)| of(*g) * orders.iter().sum::<f64>()).sum::<f64>()
    };
    let flux = sum(&|_| 1.0);
    tell!("flux {flux:.6e} (emissivity × sr), mean g {:.6}", sum(&|g| g) / flux);
}

fn time_label(scene: &Scene) -> String {
    match scene.units.and_then(|units| units.time()) {
        Some(seconds) => format!("time (1 = {seconds:.6} s)"),
        None => "time (scene units)".to_owned(),
    }
}

/// A row of the table of a kind, by its place in [`Kind::ALL`].
struct Named<const KIND: usize>(Point);

impl<const KIND: usize> Row for Named<KIND> {
    const COLUMNS: &'static [&'static str] =
        &[Kind::ALL[KIND].column(), "flux", "order_0", "order_1", "order_2", "order_3"];

    fn fields(&self) -> Vec<Field> {
        let (x, orders) = self.0;
        let values = [x, orders.iter().sum()].into_iter().chain(orders);
        values.map(|value| Field::Number(Some(value))).collect()
    }
}
