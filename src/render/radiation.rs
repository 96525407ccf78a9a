//! Sums the light of an image at each frequency.

use serde::Serialize;

use crate::scene::Scene;

/// The light of all pixels at one frequency, in the units of the layer `intensity_K`.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct FrequencyTotals {
    /// The sum of the pixels' intensities.
    pub sum: f64,
    /// The largest intensity of a pixel.
    pub brightest: f64,
    /// The sum of the pixels' optical depths.
    pub depths: f64,
    /// The number of pixels.
    pub pixels: u64,
}

impl FrequencyTotals {
    /// Adds a pixel.
    pub(super) fn add(&mut self, intensity: f64, depth: f64) {
        self.sum += intensity;
        self.brightest = self.brightest.max(intensity);
        self.depths += depth;
        self.pixels += 1;
    }

    /// Adds the pixels of another part of the image.
    pub(super) fn merge(&mut self, other: &Self) {
        self.sum += other.sum;
        self.brightest = self.brightest.max(other.brightest);
        self.depths += other.depths;
        self.pixels += other.pixels;
    }
}

/// The light of an image at one frequency.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct FrequencyReport {
    /// The frequency in hertz, if it has units.
    pub frequency_hz: Option<f64>,
    /// The frequency in units of ν₀.
    pub frequency: f64,
    /// The intensity integrated over the image, on the plane at the camera's distance, in scene units squared; `None` for cameras without
    /// such a plane.
    pub flux: Option<f64>,
    /// The flux in janskys, from `units.distance`.
    pub flux_jy: Option<f64>,
    /// The largest intensity.
    pub brightest: f64,
    /// The temperature in kelvins of a black body as bright as that, in the limit of low frequencies (Rayleigh–Jeans).
    pub brightest_temperature_k: Option<f64>,
    /// The mean optical depth of volumes; where nothing behind is seen, it may end there.
    pub mean_optical_depth: f64,
}

/// Boltzmann's constant, in erg/K.
const BOLTZMANN: f64 = 1.380_649e-16;
/// The speed of light, in cm/s.
const C: f64 = 2.997_924_58e10;
/// One jansky, in erg/(s cm² Hz).
const JANSKY: f64 = 1e-23;

/// Returns a report for each frequency of a scene.
#[must_use]
pub fn frequency_reports(scene: &Scene, totals: &[FrequencyTotals]) -> Vec<FrequencyReport> {
    let Some(radiation) = &scene.radiation else { return Vec::new() };
    let side = scene.camera.as_ref().and_then(|camera| camera.pixel_length(scene.image.size));
    let has_units = scene.intensity_unit().is_some();
    let report = |(k, own): (usize, &FrequencyTotals)| {
        let hertz = radiation.hertz(k);
        FrequencyReport {
            frequency_hz: hertz,
            frequency: radiation.frequencies[k],
            flux: side.map(|side| own.sum * side * side),
            flux_jy: scene.pixel_on_sky().filter(|_| has_units).map(|angle| own.sum * angle * angle / JANSKY),
            brightest: own.brightest,
            brightest_temperature_k: hertz
                .filter(|_| has_units)
                .map(|hertz| own.brightest * C * C / (2.0 * BOLTZMANN * hertz * hertz)),
            mean_optical_depth: own.depths / own.pixels.max(1) as f64,
        }
    };
    totals.iter().enumerate().map(report).collect()
}
