//! The ends of an image's rays, from its layers, and the distance between two runs.

use glam::DVec3;

use super::judged::{Spectrum, least_light, light_error};
use super::{Judged, Quantiles};
use crate::model::volume::MOST_FREQUENCIES;
use crate::program::Layer;
use crate::render::{Plane, Rendering, Status};
use crate::scene::Scene;

/// The layers that an image stores so that the ends of rays can be compared.
const LAYERS: [Layer; 4] = [Layer::Position, Layer::Object, Layer::Status, Layer::Way];

/// Returns these layers, followed by the layers that a search compares.
#[must_use]
pub fn compared_layers(scene: &Scene, layers: &[Layer]) -> Vec<Layer> {
    let own = LAYERS.into_iter().chain((0..scene.frequencies() as u8).map(Layer::Intensity));
    layers.iter().copied().chain(own.filter(|layer| !layers.contains(layer))).collect()
}

/// The end of a ray of the image.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct End {
    status: Status,
    seen: Seen,
}

/// The visible result of a ray.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Seen {
    Place {
        object: f32,
        place: DVec3,
        /// The direction, with the distance to the end as its length.
        way: DVec3,
    },
    Light(Spectrum),
}

/// Returns the ends of an image's rays, without pixels that have no rays.
pub(super) fn ends(rendering: &Rendering, judged: Judged) -> Vec<End> {
    let Some(Plane::Id(status)) = rendering.band.layer(Layer::Status) else { return Vec::new() };
    let seen: Box<dyn Fn(usize) -> Seen> = match judged {
        Judged::Ends => {
            let [Some(Plane::Vector(place)), Some(Plane::Scalar(object)), _, Some(Plane::Vector(way))] =
                LAYERS.map(|layer| rendering.band.layer(layer))
            else {
                return Vec::new();
            };
            let vector = |[x, y, z]: &[Vec<f32>; 3], i: usize| DVec3::new(x[i].into(), y[i].into(), z[i].into());
            Box::new(move |i| Seen::Place { object: object[i], place: vector(place, i), way: vector(way, i) })
        }
        Judged::Light => {
            let planes: Vec<_> = (0..MOST_FREQUENCIES as u8)
                .filter_map(|k| match rendering.band.layer(Layer::Intensity(k)) {
                    Some(Plane::Scalar(values)) => Some(values),
                    _ => None,
                })
                .collect();
            Box::new(move |i| {
                let mut light = Spectrum::default();
                light.iter_mut().zip(&planes).for_each(|(light, plane)| *light = plane[i].into());
                Seen::Light(light)
            })
        }
    };
    let end = |i: usize| End { status: Status::from_code(status[i]), seen: seen(i) };
    (0..status.len()).map(end).filter(|end| end.status != Status::Outside).collect()
}

impl End {
    /// Returns `true` if the ray has no end.
    fn is_endless(&self) -> bool {
        matches!(self.status, Status::Alive | Status::Exhausted | Status::Stalled | Status::Failed)
    }

    /// Returns the error as in [`ErrorStats::seen`](super::ErrorStats::seen): in radians, and infinite for another status or object; or of
    /// the light, relative to it and at least to `least`.
    fn error(&self, truth: &Self, least: &Spectrum) -> f64 {
        match (self.seen, truth.seen) {
            (Seen::Light(light), Seen::Light(known)) => light_error(&light, &known, least),
            (Seen::Place { object, place, way }, Seen::Place { object: known, place: own_place, way: own_way }) => {
                let angle = angle(way, own_way);
                match truth.status {
                    _ if (self.status, object) != (truth.status, known) => f64::INFINITY,
                    Status::Captured => 0.0,
                    Status::Escaped => angle,
                    _ => angle.max(place.distance(own_place) / own_way.length()),
                }
            }
            _ => f64::INFINITY,
        }
    }
}

/// Returns the angle between two vectors, in radians, exact for small ones too.
pub(super) fn angle(a: DVec3, b: DVec3) -> f64 {
    a.cross(b).length().atan2(a.dot(b))
}

/// The error, in radians or of the light, above which two rays are unrelated.
const UNSETTLED: f64 = 0.1;

/// The number of rays by the state of their ends.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Settled {
    /// All compared rays.
    pub all: usize,
    /// The rays with other ends at finer steps, because they are near-critical or chaotic.
    pub unsettled: usize,
    /// The rays without an end.
    pub endless: usize,
}

impl Settled {
    /// Returns `true` if more than one of a hundred rays is unsettled, so that no error for 99 is known.
    #[must_use]
    pub fn is_lacking(&self) -> bool {
        100 * self.unsettled > self.all - self.endless
    }
}

/// The reference: the ends of a run with their estimated errors.
pub(super) struct Finest {
    ends: Vec<End>,
    /// Is `Some(true)` for a ray with a settled end; `None` for a ray without an end.
    settled: Vec<Option<bool>>,
    least: Spectrum,
    /// The largest error of 99 of 100 rays.
    pub slack: f64,
    pub rays: Settled,
}

impl Finest {
    /// Creates the reference from two runs, of which the second has finer steps.
    pub fn of(coarse: &[End], fine: &[End]) -> Self {
        let least = least_light(fine.iter().filter_map(|end| match &end.seen {
            Seen::Light(light) => Some(&light[..]),
            Seen::Place { .. } => None,
        }));
        let settled: Vec<_> = coarse
            .iter()
            .zip(fine)
            .map(|(coarse, fine)| {
                let endless = coarse.is_endless() && fine.is_endless();
                (!endless).then(|| !fine.is_endless() && coarse.error(fine, &least) < UNSETTLED)
            })
            .collect();
        let count = |what: Option<bool>| settled.iter().filter(|settled| **settled == what).count();
        let rays = Settled { all: settled.len(), unsettled: count(Some(false)), endless: count(None) };
        let mut finest = Self { ends: fine.to_vec(), settled, least, slack: 0.0, rays };
        finest.slack = finest.deviation(coarse);
        finest
    }

    /// Returns the error bound of 99 of 100 rays of a run. Unsettled rays count as wrong, unless there are too many: then only
    /// the others can be judged.
    pub fn deviation(&self, ends: &[End]) -> f64 {
        let skips = self.rays.is_lacking();
        let rays = ends.iter().zip(&self.ends).zip(&self.settled);
        let errors = rays.filter_map(|((end, truth), settled)| match settled {
            Some(true) => Some(end.error(truth, &self.least)),
            Some(false) if !skips => Some(f64::INFINITY),
            _ => None,
        });
        let quantiles = Quantiles::of(errors.collect());
        self.slack.hypot(if skips { quantiles.p95 } else { quantiles.sure99 })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn end(status: Status, object: f32, place: [f64; 3], way: [f64; 3]) -> End {
        End { status, seen: Seen::Place { object, place: place.into(), way: way.into() } }
    }

    #[test]
    fn ends_are_compared_by_what_is_seen() {
        let hit = end(Status::Hit, 1.0, [0.0, 0.0, 4.0], [0.0, 0.0, 4.0]);
        let near = end(Status::Hit, 1.0, [0.04, 0.0, 4.0], [0.0, 0.0, 4.1]);
        let error = |found: &End, truth: &End| found.error(truth, &Spectrum::default());
        assert!((error(&near, &hit) - 0.01).abs() < 1e-12);
        assert!(error(&end(Status::Hit, 2.0, [0.0; 3], [1.0; 3]), &hit).is_infinite());
        assert!(error(&end(Status::Captured, 0.0, [0.0; 3], [1.0; 3]), &hit).is_infinite());
        let away = end(Status::Escaped, 0.0, [1.0; 3], [0.0, 0.0, 9.0]);
        assert!((error(&end(Status::Escaped, 0.0, [5.0; 3], [0.0, 1e-6, 1.0]), &away) - 1e-6).abs() < 1e-12);
    }
}
