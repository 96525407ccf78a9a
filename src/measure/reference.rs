//! The reference solution: the true ends of rays.

use super::judged::{least_light, light_error};
use crate::gpu::{Gpu, GpuError, adapters};
use crate::model::control::{embedded, exact};
use crate::model::method::{CLOSED_FORMS, TOLERANT};
use crate::render::{RenderError, RenderSettings, Starts, Status, Traced, Tracer, Transferred};
use crate::scene::{Precision, Scene, Segment};

/// The least reliable tolerance of f64.
pub(super) const FINEST: f64 = 1e-13;
/// The difference of directions (radians) and positions (relative to the bounding radius) up to which two runs agree.
const AGREES: f64 = 1e-6;
/// The relative difference of intensities up to which two runs agree, and the factor of the tolerance of `[radiation]`.
const AGREES_LIGHT: f64 = 1e-5;
const FINER_LIGHT: f64 = 1e-3;
/// The largest number of segments of a reference path, as a multiple of the scene's, within limits.
const MORE_SEGMENTS: u32 = 100;
const SEGMENTS: [u32; 2] = [20_000, 200_000];
/// The number of segments per pass: few rays with long paths use passes as long as the device allows.
const SEGMENTS_PER_PASS: u32 = 1024;

/// Returns the scene with the general method in 64 bits; closed forms are unchanged.
#[must_use]
pub fn reference(scene: &Scene, tolerance: f64) -> Scene {
    let mut scene = scene.clone();
    let rays = &mut scene.rays;
    rays.auto = None;
    rays.precision = Precision::Double;
    rays.max_segments = rays.max_segments.saturating_mul(MORE_SEGMENTS).clamp(SEGMENTS[0], SEGMENTS[1]);
    let arc = match rays.segment {
        Segment::Arc { tolerance } => tolerance,
        Segment::Chord { .. } => 1e-4 * rays.bounding_sphere.radius,
    };
    rays.segment = Segment::Arc { tolerance: arc.min(1e-5 * rays.bounding_sphere.radius) };
    rays.closed_forms = true;
    if let Some(radiation) = &mut scene.radiation {
        radiation.own_tolerance = Some(FINER_LIGHT * radiation.tolerance());
    }
    rays.method = TOLERANT;
    rays.control = embedded::with(tolerance.max(FINEST), 0.3);
    if scene.law.facts().closed_form.is_some() && !scene.demands().needs_solver {
        scene.rays.method = CLOSED_FORMS;
        scene.rays.control = exact::CONTROL;
    }
    scene
}

/// Returns a device with 64-bit support: the given one, or the first that supports it.
pub(crate) fn double_device(gpu: &Gpu) -> Result<Option<Gpu>, GpuError> {
    if gpu.f64 {
        return Ok(None);
    }
    let able = adapters().into_iter().find(|adapter| adapter.f64);
    let refused = || GpuError::NoDouble { device: gpu.info.name.clone(), there: Vec::new() };
    let other = Gpu::open(Some(&able.ok_or_else(refused)?.info.name))?;
    Ok(Some(other.reporting(gpu.progress.clone())))
}

/// The difference of directions, in radians, up to which the end of a ray is certain; near a critical ray, the direction becomes unknown
/// long before the end.
const CERTAIN: f64 = 0.5;

/// The known part of a ray's reference solution.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Known {
    /// The complete end.
    Whole(Traced),
    /// The termination status and the object, but not the direction or position.
    End(Traced),
    /// No part, because two runs disagree.
    Nothing,
}

impl Known {
    /// Returns the end, if it is completely known.
    #[must_use]
    pub fn whole(&self) -> Option<&Traced> {
        if let Self::Whole(ray) = self { Some(ray) } else { None }
    }

    /// Returns the end, if the termination status and the object are known.
    #[must_use]
    pub fn end(&self) -> Option<&Traced> {
        if let Self::Whole(ray) | Self::End(ray) = self { Some(ray) } else { None }
    }
}

/// The reference solutions of some rays.
#[derive(Debug, Clone)]
pub struct ReferenceSolution {
    /// The ends.
    pub ends: Vec<Known>,
    /// The intensities at each frequency, or `None` for a ray whose two runs disagree; empty without `[radiation]`.
    pub light: Vec<Option<Vec<f64>>>,
}

impl ReferenceSolution {
    /// Computes the reference solutions of rays of the scene: the camera's, or given ones.
    ///
    /// # Errors
    ///
    /// Returns [`GpuError::NoDouble`] if no device supports 64 bits, or another error if the device fails or cannot run the program.
    pub fn new(gpu: &Gpu, scene: &Scene, tolerance: f64, starts: Starts) -> Result<Self, RenderError> {
        let other = double_device(gpu)?;
        let gpu = other.as_ref().unwrap_or(gpu);
        let scene = reference(scene, tolerance);
        let settings = RenderSettings { segments: SEGMENTS_PER_PASS, ..RenderSettings::default() };
        let mut tracer = Tracer::new(gpu, &scene, settings, starts.mode())?;
        let fine = tracer.follow(starts)?.0;
        let light = intensities(tracer.spectra());
        let control = scene.rays.control;
        let Some(tolerance) = control.tolerance() else {
            let light = light.into_iter().map(Some).collect();
            return Ok(Self { ends: fine.into_iter().map(Known::Whole).collect(), light });
        };
        tracer.retune(embedded::with(10.0 * tolerance, control.cap), scene.rays.max_segments)?;
        let loose = tracer.follow(starts)?.0;
        let radius = scene.rays.bounding_sphere.radius;
        let known = |(fine, loose): (Traced, Traced)| known(fine, &loose, radius);
        let least = least_light(light.iter().map(Vec::as_slice));
        let certain =
            |(fine, loose): (Vec<f64>, Vec<f64>)| (light_error(&loose, &fine, &least) < AGREES_LIGHT).then_some(fine);
        let light = light.into_iter().zip(intensities(tracer.spectra())).map(certain).collect();
        Ok(Self { ends: fine.into_iter().zip(loose).map(known).collect(), light })
    }

    /// Returns the number of rays.
    #[must_use]
    pub fn len(&self) -> usize {
        self.ends.len()
    }

    /// Returns `true` if there are no rays.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }

    /// Returns `true` if the complete end of any ray is known.
    #[must_use]
    pub fn is_known(&self) -> bool {
        self.ends.iter().any(|ray| ray.whole().is_some())
    }

    /// Returns the number of rays whose complete end is unknown.
    #[must_use]
    pub fn unresolved(&self) -> usize {
        self.ends.iter().filter(|ray| ray.whole().is_none()).count()
    }
}

/// Returns the intensities of rays.
pub(super) fn intensities(spectra: &[Vec<Transferred>]) -> Vec<Vec<f64>> {
    spectra.iter().map(|spectrum| spectrum.iter().map(|light| light.intensity).collect()).collect()
}

/// Returns the known part of a ray's end from two runs, of which `fine` is more accurate.
fn known(fine: Traced, loose: &Traced, radius: f64) -> Known {
    let followed = !matches!(fine.status, Status::Alive | Status::Exhausted | Status::Stalled | Status::Failed);
    if !followed || (fine.status, fine.object) != (loose.status, loose.object) {
        return Known::Nothing;
    }
    let angle = fine.angle_to(loose);
    if fine.status == Status::Captured || (angle < AGREES && fine.distance_to(loose) < AGREES * radius) {
        Known::Whole(fine)
    } else if angle < CERTAIN {
        Known::End(fine)
    } else {
        Known::Nothing
    }
}
