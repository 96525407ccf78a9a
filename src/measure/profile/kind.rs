//! The three kinds of profiles, with their columns, ranges and units.

use super::fluxes::{H, K};
use super::{Emission, InvalidEmissivity, Orders, light_curve, line, spectrum};
use crate::assets::Emissivity;
use crate::program::Layer;
use crate::scene::Scene;

/// The quantity that a profile is a function of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// The flux of a spectral line per redshift factor g, in the unit of the emissivity times steradians.
    Line,
    /// The flux over all frequencies at a time of the observer, in the unit of the emissivity times steradians.
    LightCurve,
    /// The flux per frequency, in janskys at frequencies in hertz: of surfaces that radiate as black bodies, or of the whole image with
    /// `[radiation]`.
    Spectrum,
}

/// A point of a profile: g, the time or the frequency, and the flux of each order.
pub type Point = (f64, Orders);

impl Kind {
    /// All kinds.
    pub const ALL: [Self; 3] = [Self::Line, Self::LightCurve, Self::Spectrum];

    /// Returns the name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Line => "line",
            Self::LightCurve => "light-curve",
            Self::Spectrum => "spectrum",
        }
    }

    /// Returns a description for a list.
    #[must_use]
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Line => "Flux of a spectral line per redshift factor g",
            Self::LightCurve => "Flux over all frequencies against the observer's time",
            Self::Spectrum => {
                "Flux per frequency: of surfaces that radiate as black bodies, or of the image with [radiation]"
            }
        }
    }

    /// Returns the name of the first column.
    #[must_use]
    pub const fn column(self) -> &'static str {
        match self {
            Self::Line => "g",
            Self::LightCurve => "t",
            Self::Spectrum => "frequency",
        }
    }

    /// Returns why there is no such profile with a range, and with an emissivity if `is_given`.
    #[must_use]
    pub fn refuses(self, range: Option<[f64; 2]>, is_given: bool) -> Option<String> {
        if self == Self::Spectrum && is_given {
            return Some("a spectrum follows from the temperature of the material, and has no emissivity".to_owned());
        }
        let Some([from, to]) = range else {
            let missing = "a light curve requires a range, the first and the last time";
            return (self == Self::LightCurve).then(|| missing.to_owned());
        };
        let starts = match self {
            Self::Line => from >= 0.0,
            Self::LightCurve => true,
            Self::Spectrum => from > 0.0,
        };
        let fits = starts && from < to && from.is_finite() && to.is_finite();
        let rule = "the first value must be below the second, and frequencies above 0";
        (!fits).then(|| format!("the range {from},{to} is empty or impossible: {rule}"))
    }

    /// Returns why a scene has no such profile with the light of these objects, or of all.
    #[must_use]
    pub fn refuses_scene(self, scene: &Scene, objects: Option<&[u32]>) -> Option<String> {
        let count = scene.objects.len();
        if scene.camera.as_ref().is_some_and(|camera| camera.stereo.is_some()) {
            return Some("a profile is for one eye: remove camera.stereo".to_owned());
        }
        if self == Self::Spectrum && scene.radiation.is_some() {
            return refuses_radiation(scene, objects).map(str::to_owned);
        }
        if let Some(refusal) = Layer::CrossingRedshift.refused_by(scene) {
            return Some(refusal.to_owned());
        }
        if let Some(index) = objects.into_iter().flatten().find(|index| **index as usize >= count) {
            let objects = if count == 1 { "object" } else { "objects" };
            return Some(format!("there is no object {index}: the scene has {count} {objects}, counted from 0"));
        }
        let mut surfaces = scene.objects.iter().filter_map(|object| Some(&scene.materials[object.material()?].surface));
        let is_cold = self == Self::Spectrum && surfaces.all(|surface| surface.temperature().is_none());
        let missing = "a spectrum requires a surface with a temperature in kelvins: set `temperature` of a material of \
                       kind accretion or blackbody";
        is_cold.then(|| missing.to_owned())
    }
}

/// Returns why a scene with `[radiation]` has no spectrum with the light of these objects, or of all.
fn refuses_radiation(scene: &Scene, objects: Option<&[u32]>) -> Option<&'static str> {
    let has_plane = scene.camera.as_ref().is_some_and(|camera| camera.pixel_length(scene.image.size).is_some());
    match objects {
        Some(_) => Some("with [radiation], a spectrum is that of the whole image: remove --object"),
        None if !has_plane => {
            Some("the camera has no plane on which light could be summed: use pinhole or orthographic")
        }
        None => None,
    }
}

/// Returns a profile of `count` points, 2 or more. Without a range, it spans all g of the light, or the frequencies at which the surfaces are
/// bright; a light curve needs one.
///
/// # Errors
///
/// Returns [`InvalidEmissivity`] if the emissivity is not a number from 0 at a crossing.
pub fn measure(
    kind: Kind,
    scene: &Scene,
    emissions: &[Emission],
    emissivity: &Emissivity,
    range: Option<[f64; 2]>,
    count: usize,
) -> Result<Vec<Point>, InvalidEmissivity> {
    let part = |k: usize| k as f64 / (count - 1) as f64;
    Ok(match kind {
        Kind::Line => {
            let (fluxes, [low, high]) = line(emissions, emissivity, range, count)?;
            let per_bin = (high - low) / count as f64;
            (0..count).map(|k| low + (k as f64 + 0.5) * per_bin).zip(fluxes).collect()
        }
        Kind::LightCurve => {
            let [from, to] = range.unwrap_or_default();
            let times: Vec<f64> = (0..count).map(|k| from + (to - from) * part(k)).collect();
            let fluxes = light_curve(emissions, emissivity, &times)?;
            times.into_iter().zip(fluxes).collect()
        }
        Kind::Spectrum => {
            let [from, to] = range.unwrap_or_else(|| bright_band(emissions));
            let frequencies: Vec<f64> = (0..count).map(|k| from * (to / from).powf(part(k))).collect();
            let (fluxes, janskys) = (spectrum(emissions, &frequencies), janskys(scene));
            let scaled = fluxes.into_iter().map(|orders| orders.map(|flux| flux * janskys));
            frequencies.into_iter().zip(scaled).collect()
        }
    })
}

/// Returns the range of frequencies, in hertz, in which surfaces that radiate as black bodies are bright.
fn bright_band(emissions: &[Emission]) -> [f64; 2] {
    /// Wien's law: the frequency at which a black body is brightest, in units of k T/h.
    const PEAK: f64 = 2.821_439_372_122_08;
    let hottest = emissions.iter().filter_map(|e| Some(e.g * e.temperature?)).fold(1e-3, f64::max);
    [1e-3, 10.0].map(|part| part * PEAK * K * hottest / H)
}

/// Returns the factor from a flux at the camera in W m⁻² Hz⁻¹ to the flux in janskys at the distance in the scene's `[units]`, or at the
/// camera without one.
fn janskys(scene: &Scene) -> f64 {
    let angle = scene.units.and_then(|units| units.angle());
    let nearer = scene.camera.as_ref().zip(angle).map_or(1.0, |(camera, angle)| camera.distance * angle);
    1e26 * nearer * nearer
}
