//! The convergence of light with the tolerance of `[radiation]`, by the fastest of the accurate settings of a sweep.

use std::path::Path;

use super::timed::timed;
use crate::gpu::Gpu;
use crate::measure::{ErrorStats, Quantiles, ReferenceSolution, flux_error};
use crate::output::OutputError;
use crate::output::plot::{Chart, Series};
use crate::output::table::{Field, Row, Table};
use crate::program::{ProgramOptions, Schedule};
use crate::render::{RenderError, RenderSettings, Renderer, Starts, Tracer};
use crate::scene::Scene;

/// A tolerance of `[radiation]`.
#[derive(Debug, Clone, PartialEq)]
pub struct TransferPoint {
    /// The tolerance.
    pub tolerance: f64,
    /// The median time of the advance and intersection passes per ray, in seconds.
    pub time: f64,
    /// The errors of the intensities of rays, relative to them.
    pub rays: Quantiles,
    /// The error of the light of these rays together, relative to it.
    pub flux: f64,
}

/// The tolerances, from loose to tight.
const TOLERANCES: [f64; 7] = [1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7];

/// Measures each tolerance, timing images of this schedule by the median of repeats.
pub(super) fn transfer_points(
    gpu: &Gpu,
    (schedule, repeats): (Schedule, usize),
    scene: &Scene,
    starts: Starts,
    truth: &ReferenceSolution,
) -> Result<Vec<TransferPoint>, RenderError> {
    let point = |tolerance| {
        let mut scene = scene.clone();
        scene.radiation.iter_mut().for_each(|radiation| radiation.own_tolerance = Some(tolerance));
        let options = ProgramOptions { schedule, ..ProgramOptions::default() };
        let settings = RenderSettings { segments: 256, ..RenderSettings::default() };
        let mut few = Tracer::new(gpu, &scene, settings.clone(), starts.mode())?;
        let (rays, _) = few.follow(starts)?;
        let found = ErrorStats::new(&rays, few.spectra(), truth);
        let mut all = Renderer::new(gpu, &scene, RenderSettings { options, apart: true, ..settings })?;
        // The first run compiles.
        all.render()?;
        let pixels = f64::from(scene.image.size[0]) * f64::from(scene.image.size[1]);
        let time = timed(&mut all, repeats)?.seconds / pixels;
        let rays = found.light.unwrap_or_else(|| Quantiles::of(Vec::new()));
        Ok(TransferPoint { tolerance, time, rays, flux: flux_error(few.spectra(), truth) })
    };
    TOLERANCES.into_iter().map(point).collect()
}

impl Row for TransferPoint {
    const COLUMNS: &'static [&'static str] =
        &["tolerance", "ns_per_ray", "light_median", "light_p95", "light_p99", "light_max", "flux"];

    fn fields(&self) -> Vec<Field> {
        let Quantiles { median, p95, p99, max, .. } = self.rays;
        [self.tolerance, 1e9 * self.time, median, p95, p99, max, self.flux].map(Field::Measured).to_vec()
    }
}

/// Writes a table of all tolerances.
pub(super) fn write_transfer(path: &Path, points: &[TransferPoint]) -> Result<(), OutputError> {
    let mut table = Table::create::<TransferPoint>(path)?;
    points.iter().try_for_each(|point| table.write(point))?;
    table.finish()
}

/// Returns the chart of errors against tolerances.
pub(super) fn transfer_chart(title: &str, points: &[TransferPoint]) -> Chart {
    let line = |name: &str, of: fn(&TransferPoint) -> f64| {
        Series::new(name, points.iter().map(|point| [point.tolerance, of(point)]).collect())
    };
    let series = vec![
        line("rays, maximum", |point| point.rays.max),
        line("rays, 95th percentile", |point| point.rays.p95),
        line("flux", |point| point.flux),
    ];
    Chart::logarithmic(title, ["radiation.tolerance", "relative error of the light"], series)
}
