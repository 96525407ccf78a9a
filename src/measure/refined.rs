//! A method against itself with finer steps: what it errs by, found with the picture's own program.
//!
//! *Theory.* Steps of a fixed part of the law's scale are refined until two runs agree ten times better than is asked for; the
//! finer one then stands for the truth, and what they differ by is added to every error that is measured against it.
//!
//! *Practice.* Nothing is compiled that the picture does not run anyway, which is most of what trying a method costs. Rounding
//! shows as a difference that finer steps do not mend; then, and wherever else the two runs disagree, nothing is found, and the
//! method has to be measured against 64 bits.

use std::sync::Arc;

use glam::DVec3;

use super::{Candidate, Quantiles, cost};
use crate::gpu::Gpu;
use crate::model::control::scaled;
use crate::program::{Choice, Layer, Purpose};
use crate::render::{self, Plane, RenderError, RenderSettings, Renderer, Status};
use crate::scene::{Control, LightGrid, Picture, Scene};

/// Rays that are compared, about.
const RAYS: f64 = 4096.0;
/// Less cannot be told from the rounding of positions and directions in 32 bits.
const LEAST: f64 = 1e-5;
/// How much better than asked for two runs agree, of which the finer stands for the truth.
const AGREES: f64 = 0.1;
/// The settings, from coarse to fine, that may stand for the truth; each is compared with the one before.
const TRUTHS: [usize; 2] = [7, 10];
/// The setting that is tried first.
const FIRST: usize = 2;
/// What a picture keeps so that its rays' ends can be compared.
pub(super) const LAYERS: [Layer; 4] = [Layer::Position, Layer::Object, Layer::Status, Layer::Way];

/// These layers, and after them those that are compared besides.
#[must_use]
pub fn compared_layers(layers: &[Layer]) -> Vec<Layer> {
    layers.iter().copied().chain(LAYERS.into_iter().filter(|layer| !layers.contains(layer))).collect()
}

/// A method at the coarsest of its settings that is right.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Found {
    pub control: Control,
    /// 99 of 100 rays err by no more, in radians.
    pub error: f64,
    /// What a ray costs, in evaluations of a simple derivative.
    pub cost: f64,
}

/// Can the method be compared with itself? Its steps must be parts of the law's scale, and no surface may split or bend the rays.
fn comparable(scene: &Scene, choice: &Choice, candidate: &Candidate, accuracy: f64) -> bool {
    let scaled = candidate.controls.iter().all(|control| *control.kind == scaled::KIND);
    scaled
        && candidate.controls.len() > TRUTHS[1]
        && accuracy >= LEAST
        && choice.purpose == Purpose::Picture
        && scene.camera.is_some()
        && !scene.scatters()
}

/// The coarsest setting of a method by which 99 of 100 of the picture's rays err by no more than `accuracy`, radians; none where
/// that cannot be said.
pub(super) fn first_right(
    gpu: &Gpu,
    scene: &Scene,
    settings: &RenderSettings,
    candidate: &Candidate,
    max_segments: u32,
    accuracy: f64,
) -> Result<Option<Found>, RenderError> {
    if !comparable(scene, &settings.choice, candidate, accuracy) {
        return Ok(None);
    }
    let controls = &candidate.controls;
    let mut small = candidate.applied(scene, controls[TRUTHS[0]]);
    small.image.size = reduced(scene.image.size);
    small.rays.max_segments = max_segments;
    // The first sample is all that is compared.
    (small.image.adaptive, small.image.footprints) = (None, false);
    // What is seen there does not matter, only where.
    for picture in &mut small.pictures {
        *picture = Picture { size: [1, 1], pixels: Arc::new(vec![[0.0; 3]]), name: picture.name.clone() };
    }
    for light in &mut small.lights {
        light.grid = LightGrid::COARSEST;
    }
    let settings = RenderSettings { window: None, segments: 256, ..settings.clone() };
    let mut renderer = Renderer::new(gpu, &small, settings)?;
    let mut run = |k: usize| -> Result<(Vec<End>, f64), RenderError> {
        renderer.retune(controls[k], small.rays.max_segments)?;
        let render::Rendering { band, totals } = renderer.first_sample()?;
        let [steps, rejected] = [totals.steps, totals.rejected].map(|count| count as f64 / totals.rays.max(1) as f64);
        let plane = |layer| band.layer(layer);
        Ok((ends(LAYERS.map(plane)), cost(scene, candidate.method, controls[k], steps, rejected)))
    };
    let Some((truth, finest, slack)) = truth(&mut run, accuracy)? else { return Ok(None) };
    let mut k = FIRST;
    let mut best = None;
    while k < finest {
        let (rays, cost) = run(k)?;
        let error = slack + deviation(&rays, &truth);
        if error <= accuracy {
            let better = best.is_none();
            best = Some(Found { control: controls[k], error, cost });
            // An error of the fourth order says how far one may go.
            let further = ((accuracy / error).ln() / (0.75_f64.powi(-4)).ln()).floor() as usize;
            if !better || further == 0 || k == 0 {
                break;
            }
            k = k.saturating_sub(further);
        } else if best.is_some() {
            break;
        } else {
            k += 1;
        }
    }
    Ok(best)
}

/// What stands for the truth, which setting it is of, and what it may be off by.
fn truth(
    run: &mut impl FnMut(usize) -> Result<(Vec<End>, f64), RenderError>,
    accuracy: f64,
) -> Result<Option<(Vec<End>, usize, f64)>, RenderError> {
    for k in TRUTHS {
        let (coarse, fine) = (run(k - 1)?.0, run(k)?.0);
        let slack = deviation(&coarse, &fine);
        if slack <= AGREES * accuracy {
            return Ok(Some((fine, k, slack)));
        }
    }
    Ok(None)
}

/// The picture's size, or a smaller one of about its shape with no more rays than are compared.
fn reduced([width, height]: [u32; 2]) -> [u32; 2] {
    let scale = (RAYS / (f64::from(width) * f64::from(height))).sqrt().min(1.0);
    [width, height].map(|side| ((f64::from(side) * scale).round() as u32).max(1))
}

/// Where a ray of the picture ended.
#[derive(Debug, Clone, Copy, PartialEq)]
struct End {
    status: Status,
    object: u32,
    place: DVec3,
    /// Its direction, as long as the way to its end.
    way: DVec3,
}

/// From the planes of [`LAYERS`].
fn ends(planes: [Option<&Plane>; 4]) -> Vec<End> {
    let [Some(Plane::Vector(place)), Some(Plane::Id(object)), Some(Plane::Id(status)), Some(Plane::Vector(way))] =
        planes
    else {
        return Vec::new();
    };
    let vector = |[x, y, z]: &[Vec<f32>; 3], i: usize| DVec3::new(x[i].into(), y[i].into(), z[i].into());
    let end = |i: usize| End {
        status: Status::from_code(status[i]),
        object: object[i],
        place: vector(place, i),
        way: vector(way, i),
    };
    (0..status.len()).map(end).collect()
}

/// 99 of 100 rays are off by no more, in radians; no number where there are none.
fn deviation(rays: &[End], truth: &[End]) -> f64 {
    let there = rays.iter().zip(truth).filter(|(_, truth)| truth.status != Status::Outside);
    Quantiles::of(there.map(|(ray, truth)| seen(ray, truth)).collect()).sure99
}

/// As [`Deviations::seen`](super::Deviations::seen): a wrong end is beyond all bounds, and so is one that is not known.
fn seen(ray: &End, truth: &End) -> f64 {
    let lost = matches!(truth.status, Status::Alive | Status::Exhausted | Status::Stalled | Status::Failed);
    if lost || (ray.status, ray.object) != (truth.status, truth.object) {
        return f64::INFINITY;
    }
    let angle = ray.way.cross(truth.way).length().atan2(ray.way.dot(truth.way));
    match truth.status {
        Status::Captured => 0.0,
        Status::Escaped => angle,
        _ => angle.max(ray.place.distance(truth.place) / truth.way.length()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn large_pictures_are_tried_on_small_ones_of_their_shape() {
        assert_eq!(reduced([64, 64]), [64, 64]);
        assert_eq!(reduced([30, 20]), [30, 20]);
        assert_eq!(reduced([1600, 900]), [85, 48]);
        assert_eq!(reduced([60_000, 1]), [4096, 1].map(|side: u32| if side == 1 { 1 } else { 15_677 }));
    }

    #[test]
    fn ends_are_compared_by_what_is_seen() {
        let end = |status, object, place: [f64; 3], way: [f64; 3]| End {
            status,
            object,
            place: place.into(),
            way: way.into(),
        };
        let hit = end(Status::Hit, 1, [0.0, 0.0, 4.0], [0.0, 0.0, 4.0]);
        let near = end(Status::Hit, 1, [0.04, 0.0, 4.0], [0.0, 0.0, 4.1]);
        assert!((seen(&near, &hit) - 0.01).abs() < 1e-12);
        assert!(seen(&end(Status::Hit, 2, [0.0; 3], [1.0; 3]), &hit).is_infinite());
        assert!(seen(&end(Status::Captured, 0, [0.0; 3], [1.0; 3]), &hit).is_infinite());
        let away = end(Status::Escaped, 0, [1.0; 3], [0.0, 0.0, 9.0]);
        assert!((seen(&end(Status::Escaped, 0, [5.0; 3], [0.0, 1e-6, 1.0]), &away) - 1e-6).abs() < 1e-12);
        let lost = end(Status::Exhausted, 0, [0.0; 3], [0.0; 3]);
        assert!(seen(&lost, &lost).is_infinite());
    }
}
