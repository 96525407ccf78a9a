//! The spectrum of a scene whose volumes radiate: the flux of its image at many frequencies.

use crate::gpu::Gpu;
use crate::model::volume::{MOST_FREQUENCIES, Radiation, Show};
use crate::render::{RenderError, RenderSettings, Renderer, Totals, frequency_reports};
use crate::scene::Scene;

/// The spectrum of an image, in the units that its scene has.
#[derive(Debug, Clone)]
pub struct RadiationSpectrum {
    /// Is `true` if frequencies are in hertz; otherwise they are in units of ν₀.
    pub in_hertz: bool,
    /// Is `true` if fluxes are in janskys; otherwise they are as in [`FrequencyReport::flux`](crate::render::FrequencyReport::flux).
    pub in_janskys: bool,
    /// The frequencies and the fluxes.
    pub points: Vec<[f64; 2]>,
    /// The totals of all renders.
    pub totals: Totals,
}

/// The default range, as factors of the lowest and the highest frequency of the scene.
const BEYOND: [f64; 2] = [0.1, 10.0];

impl RadiationSpectrum {
    /// Returns the flux at `count` frequencies, 2 or more, in equal ratios from the first to the last of `range`, by default from a tenth of
    /// the scene's lowest frequency to ten times its highest. Several frequencies share one path. Fluxes are not numbers for a camera without
    /// a plane.
    ///
    /// # Errors
    ///
    /// Returns the errors of [`Renderer::new`] and [`Renderer::render`].
    pub fn new(
        gpu: &Gpu,
        (scene, radiation): (&Scene, &Radiation),
        settings: &RenderSettings,
        range: Option<[f64; 2]>,
        count: usize,
    ) -> Result<Self, RenderError> {
        let unit = radiation.reference.unwrap_or(1.0);
        let own = radiation.frequencies.iter().map(|frequency| unit * frequency);
        let lowest = own.clone().fold(f64::INFINITY, f64::min);
        let [from, to] = range.unwrap_or([BEYOND[0] * lowest, BEYOND[1] * own.fold(0.0, f64::max)]);
        let at = |k: usize| from * (to / from).powf(k as f64 / (count - 1) as f64);
        let frequencies: Vec<f64> = (0..count).map(at).collect();
        let mut found = Self {
            in_hertz: radiation.reference.is_some(),
            in_janskys: true,
            points: Vec::new(),
            totals: Totals::default(),
        };
        let stage = gpu.progress.counted("frequencies", count);
        for part in frequencies.chunks(MOST_FREQUENCIES) {
            stage.reach(found.points.len() as f64);
            let mut scene = scene.clone();
            let frequencies = part.iter().map(|frequency| frequency / unit).collect();
            scene.radiation = Some(Radiation { frequencies, show: Show::Gray, ..radiation.clone() });
            let totals = Renderer::new(gpu, &scene, settings.clone())?.render()?.totals;
            for (frequency, report) in part.iter().zip(frequency_reports(&scene, &totals.radiation)) {
                found.in_janskys &= report.flux_jy.is_some();
                found.points.push([*frequency, report.flux_jy.or(report.flux).unwrap_or(f64::NAN)]);
            }
            found.totals.add(&totals);
        }
        Ok(found)
    }
}
