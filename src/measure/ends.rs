//! Where the rays of a picture ended, as its layers tell, and how far two runs are apart.

use glam::DVec3;

use super::Quantiles;
use crate::program::Layer;
use crate::render::{Plane, Rendering, Status};

/// What a picture keeps so that its rays' ends can be compared.
const LAYERS: [Layer; 4] = [Layer::Position, Layer::Object, Layer::Status, Layer::Way];

/// These layers, and after them those that are compared besides.
#[must_use]
pub fn compared_layers(layers: &[Layer]) -> Vec<Layer> {
    layers.iter().copied().chain(LAYERS.into_iter().filter(|layer| !layers.contains(layer))).collect()
}

/// Where a ray of the picture ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct End {
    status: Status,
    object: u32,
    place: DVec3,
    /// Its direction, as long as the way to its end.
    way: DVec3,
}

/// The ends of a picture's rays; those that a picture does not have are left out.
pub(super) fn ends(rendering: &Rendering) -> Vec<End> {
    let [Some(Plane::Vector(place)), Some(Plane::Id(object)), Some(Plane::Id(status)), Some(Plane::Vector(way))] =
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
    /// Did the ray come to no end at all?
    fn is_endless(&self) -> bool {
        matches!(self.status, Status::Alive | Status::Exhausted | Status::Stalled | Status::Failed)
    }

    /// As [`Deviations::seen`](super::Deviations::seen), in radians: an end of another kind, or on another object, is beyond all
    /// bounds.
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

/// Rays whose directions differ by more than this, in radians, have nothing to do with each other any more.
const UNSETTLED: f64 = 0.1;

/// Rays by whether their ends are known.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Settled {
    /// All that were compared.
    pub all: usize,
    /// Those that end otherwise with finer steps, as close to a critical ray or in chaos.
    pub unsettled: usize,
    /// Those that come to no end.
    pub endless: usize,
}

impl Settled {
    /// Are more than one of a hundred unsettled, so that nothing can be said of 99?
    #[must_use]
    pub fn is_lacking(&self) -> bool {
        100 * self.unsettled > self.all - self.endless
    }
}

/// What stands for the truth: the ends of a run, and what they are off by.
pub(super) struct Finest {
    ends: Vec<End>,
    /// Is the end of a ray settled; none where it has no end.
    settled: Vec<Option<bool>>,
    /// What 99 of 100 rays are off by, at most, in radians.
    pub slack: f64,
    pub rays: Settled,
}

impl Finest {
    /// Of two runs, of which the second has finer steps.
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

    /// 99 of 100 rays of a run are off by no more, in radians. Unsettled rays count as wrong, unless there are so many that only
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

    fn end(status: Status, object: u32, place: [f64; 3], way: [f64; 3]) -> End {
        End { status, object, place: place.into(), way: way.into() }
    }

    #[test]
    fn ends_are_compared_by_what_is_seen() {
        let hit = end(Status::Hit, 1, [0.0, 0.0, 4.0], [0.0, 0.0, 4.0]);
        let near = end(Status::Hit, 1, [0.04, 0.0, 4.0], [0.0, 0.0, 4.1]);
        assert!((near.seen(&hit) - 0.01).abs() < 1e-12);
        assert!(end(Status::Hit, 2, [0.0; 3], [1.0; 3]).seen(&hit).is_infinite());
        assert!(end(Status::Captured, 0, [0.0; 3], [1.0; 3]).seen(&hit).is_infinite());
        let away = end(Status::Escaped, 0, [1.0; 3], [0.0, 0.0, 9.0]);
        assert!((end(Status::Escaped, 0, [5.0; 3], [0.0, 1e-6, 1.0]).seen(&away) - 1e-6).abs() < 1e-12);
    }
}
