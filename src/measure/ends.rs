//! The ends of an image's rays, from its layers, and the distance between two runs.

use glam::DVec3;

use super::Quantiles;
use crate::program::Layer;
use crate::render::{Plane, Rendering, Status};

/// The layers that an image stores so that the ends of rays can be compared.
const LAYERS: [Layer; 4] = [Layer::Position, Layer::Object, Layer::Status, Layer::Way];

/// Returns these layers, followed by other layers to compare.
#[must_use]
pub fn compared_layers(layers: &[Layer]) -> Vec<Layer> {
    layers.iter().copied().chain(LAYERS.into_iter().filter(|layer| !layers.contains(layer))).collect()
}

/// The end of a ray of the image.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct End {
    status: Status,
    object: f32,
    place: DVec3,
    /// The direction, with the distance to the end as its length.
    way: DVec3,
}

/// Returns the ends of an image's rays, without pixels that have no rays.
pub(super) fn ends(rendering: &Rendering) -> Vec<End> {
    let [Some(Plane::Vector(place)), Some(Plane::Scalar(object)), Some(Plane::Id(status)), Some(Plane::Vector(way))] =
        LAYERS.map(|layer| rendering.band.layer(layer))
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
    (0..status.len()).map(end).filter(|end| end.status != Status::Outside).collect()
}

impl End {
    /// Returns `true` if the ray has no end.
    fn is_endless(&self) -> bool {
        matches!(self.status, Status::Alive | Status::Exhausted | Status::Stalled | Status::Failed)
    }

    /// Returns the error as in [`ErrorStats::seen`](super::ErrorStats::seen), in radians; infinite for another status or object.
    fn seen(&self, truth: &Self) -> f64 {
        if (self.status, self.object) != (truth.status, truth.object) {
            return f64::INFINITY;
        }
        let angle = angle(self.way, truth.way);
        match truth.status {
            Status::Captured => 0.0,
            Status::Escaped => angle,
            _ => angle.max(self.place.distance(truth.place) / truth.way.length()),
        }
    }
}

/// Returns the angle between two vectors, in radians, exact for small ones too.
pub(super) fn angle(a: DVec3, b: DVec3) -> f64 {
    a.cross(b).length().atan2(a.dot(b))
}

/// The difference of directions, in radians, above which two rays are unrelated.
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
    /// The largest error of 99 of 100 rays, in radians.
    pub slack: f64,
    pub rays: Settled,
}

impl Finest {
    /// Creates the reference from two runs, of which the second has finer steps.
    pub fn of(coarse: &[End], fine: &[End]) -> Self {
        let settled: Vec<_> = coarse
            .iter()
            .zip(fine)
            .map(|(coarse, fine)| {
                let endless = coarse.is_endless() && fine.is_endless();
                (!endless).then(|| !fine.is_endless() && coarse.seen(fine) < UNSETTLED)
            })
            .collect();
        let count = |what: Option<bool>| settled.iter().filter(|settled| **settled == what).count();
        let rays = Settled { all: settled.len(), unsettled: count(Some(false)), endless: count(None) };
        let mut finest = Self { ends: fine.to_vec(), settled, slack: 0.0, rays };
        finest.slack = finest.deviation(coarse);
        finest
    }

    /// Returns the error bound of 99 of 100 rays of a run, in radians. Unsettled rays count as wrong, unless there are too many: then only
    /// the others can be judged.
    pub fn deviation(&self, ends: &[End]) -> f64 {
        let skips = self.rays.is_lacking();
        let rays = ends.iter().zip(&self.ends).zip(&self.settled);
        let errors = rays.filter_map(|((end, truth), settled)| match settled {
            Some(true) => Some(end.seen(truth)),
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
        End { status, object, place: place.into(), way: way.into() }
    }

    #[test]
    fn ends_are_compared_by_what_is_seen() {
        let hit = end(Status::Hit, 1.0, [0.0, 0.0, 4.0], [0.0, 0.0, 4.0]);
        let near = end(Status::Hit, 1.0, [0.04, 0.0, 4.0], [0.0, 0.0, 4.1]);
        assert!((near.seen(&hit) - 0.01).abs() < 1e-12);
        assert!(end(Status::Hit, 2.0, [0.0; 3], [1.0; 3]).seen(&hit).is_infinite());
        assert!(end(Status::Captured, 0.0, [0.0; 3], [1.0; 3]).seen(&hit).is_infinite());
        let away = end(Status::Escaped, 0.0, [1.0; 3], [0.0, 0.0, 9.0]);
        assert!((end(Status::Escaped, 0.0, [5.0; 3], [0.0, 1e-6, 1.0]).seen(&away) - 1e-6).abs() < 1e-12);
    }
}
