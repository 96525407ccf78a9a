//! Reads where rays cross translucent surfaces, in the coordinates in which spacetimes are usually described.

use glam::{DVec3, DVec4};
use rayon::prelude::*;

use super::records::{Records, Row};
use crate::program::{CROSSINGS, Field, Layer};
use crate::scene::Scene;

/// A point at which a ray crosses a translucent surface, or ends on a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Crossing {
    /// The index of the scene's object.
    pub object: u32,
    /// The position.
    pub x: [f64; 3],
    /// The path parameter τ.
    pub tau: f64,
    /// The radius r, in scene units: the Boyer–Lindquist radius of a rotating black hole, otherwise the distance from the law's center, or
    /// from the object's center if the law has none.
    pub radius: f64,
    /// The azimuth φ, from −π to π, counterclockwise about the law's axis, or the object's y axis.
    pub azimuth: f64,
    /// The travel time t of light to the start of the ray, in scene units: Boyer–Lindquist time around a rotating black hole. `None` if τ is
    /// not a time.
    pub time: Option<f64>,
    /// The redshift factor g, for an observer at the camera, or at the start of a given ray. `None` if light has no frequency.
    pub redshift: Option<f64>,
    /// The angle between the light and the surface normal, 0 to π/2, in the frame of the matter. `None` if the frame is unknown.
    pub angle: Option<f64>,
}

/// The crossings of each ray in order, of which only the first are stored.
pub type Crossings = [Option<Crossing>; CROSSINGS];

/// Returns the crossings of the rays of a tile.
pub(super) fn crossings(records: &Records, scene: &Scene) -> Vec<Crossings> {
    let fields = [records.field("crossed"), records.field("crossings")];
    records.par_rows().map(|row| of_ray(&row, fields, scene)).collect()
}

fn of_ray(row: &Row, [crossed, values]: [Option<&Field>; 2], scene: &Scene) -> Crossings {
    let count = row.word(crossed) as usize;
    let numbers = row.numbers::<{ 4 * (1 + ROWS * CROSSINGS) }>(values);
    let (rows, _) = numbers.as_chunks();
    let start = DVec4::from_array(rows[0]);
    let (points, _) = rows[1..].as_chunks();
    std::array::from_fn(|k| {
        let rows: &[[f64; 4]; ROWS] = points.get(k).filter(|_| k < count)?;
        Some(crossing(rows.map(DVec4::from_array), start, scene))
    })
}

/// The number of rows of a crossing, as in `shaders/segment/crossings.wgsl`.
const ROWS: usize = 3;

fn crossing([place, light, surface]: [DVec4; ROWS], start: DVec4, scene: &Scene) -> Crossing {
    let (x, tau) = (place.truncate(), place.w);
    let object = surface.w as u32 - 1;
    let around = |x| scene.law.spherical(x).unwrap_or_else(|| scene.objects[object as usize].spherical(x));
    let here = around(x);
    let redshift = Some(light.w).filter(|g| *g != 0.0);
    Crossing {
        object,
        x: x.to_array(),
        tau,
        radius: here.radius,
        azimuth: here.azimuth,
        time: scene
            .law
            .facts()
            .keeps_time
            .then(|| start.w + tau - around(start.truncate()).time_ahead + here.time_ahead),
        redshift,
        angle: angle(x, light.truncate(), surface.truncate(), redshift, scene)
            .filter(|_| scene.objects[object as usize].travel.is_none()),
    }
}

/// Returns the angle between light and a normal. In the frame of matter that moves along the surface, the cosine is g |K·N| for a covector N
/// of length 1, because the frequency there is 1/g.
fn angle(x: DVec3, light: DVec3, normal: DVec3, redshift: Option<f64>, scene: &Scene) -> Option<f64> {
    let cosine = match scene.law.metric(x, 0.0) {
        Some(metric) => {
            let normal = normal.extend(0.0);
            redshift? * light.extend(0.0).dot(normal).abs() / normal.dot(metric.inverse() * normal).sqrt()
        }
        None => light.normalize().dot(normal).abs(),
    };
    Some(cosine.min(1.0).acos())
}

impl Crossing {
    /// Returns the value of a layer of crossings; 0 if it is unknown.
    #[must_use]
    pub fn value(&self, layer: Layer) -> f64 {
        match layer {
            Layer::CrossingRadius => self.radius,
            Layer::CrossingAzimuth => self.azimuth,
            Layer::CrossingTime => self.time.unwrap_or(0.0),
            Layer::CrossingRedshift => self.redshift.unwrap_or(0.0),
            Layer::CrossingAngle => self.angle.unwrap_or(0.0),
            _ => 0.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::constant;

    #[test]
    fn the_host_and_the_device_store_the_same_rows() {
        assert_eq!(constant("segment/crossings", "CROSSINGS_KEPT") as usize, CROSSINGS);
        assert_eq!(constant("segment/crossings", "CROSSING_ROWS") as usize, ROWS);
    }
}
