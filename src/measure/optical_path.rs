//! The length ∫ ds and the optical path ∫ n ds of rays in media.
//!
//! *Theory.* The path parameter of a ray in a medium has dx/dτ = v with |v| = n and d²x/dτ² = ½∇n², so that ds = n dτ, and the optical
//! path is ∫ n² dτ.
//!
//! *Practice.* Rays are followed by the reference solution's method in 64 bits, in short steps. Between the ends of a step the path is a
//! quintic with the positions, velocities and accelerations at both, and n comes from the host's formula of the medium. At a surface the
//! velocity at the end of a step belongs to the ray behind the surface; there the path is a quartic without it.

use std::sync::Arc;

use glam::DVec3;

use super::reference::{FINEST, reference};
use crate::gpu::Gpu;
use crate::model::Medium;
use crate::model::control::embedded;
use crate::model::method::TOLERANT;
use crate::render::{PathPoint, RenderError, RenderSettings, Status, trace_paths};
use crate::scene::Scene;

/// The lengths of a ray's path.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OpticalPath {
    /// The status of the ray.
    pub status: Status,
    /// The length ∫ ds, in scene units.
    pub length: f64,
    /// The optical path ∫ n ds, in scene units.
    pub optical: f64,
}

/// Returns why the optical paths of a scene are unknown: its law is not a medium, or only shaders can compute an index.
#[must_use]
pub fn refuses_optical_paths(scene: &Scene) -> Option<&'static str> {
    let law = scene.law.facts();
    if law.medium().is_none() && !law.is_straight {
        return Some("optical paths require law.kind = \"medium\" or \"straight\"");
    }
    let is_unknown = scene.media().any(|medium| medium.index(DVec3::splat(1e-3)).is_none());
    is_unknown.then_some("optical paths are unknown in noise, grids and other media whose index only shaders compute")
}

/// Follows `rays` in 64 bits, and returns the lengths of their paths.
///
/// # Errors
///
/// Returns the errors of [`trace_paths`]; the device must support 64 bits.
pub fn optical_paths(
    gpu: &Gpu,
    scene: &Scene,
    settings: &RenderSettings,
    rays: &[[f64; 6]],
) -> Result<Vec<OpticalPath>, RenderError> {
    let mut fine = reference(scene, FINEST);
    fine.rays.closed_forms = false;
    (fine.rays.method, fine.rays.control) = (TOLERANT, embedded::with(FINEST, 0.3));
    let paths = trace_paths(gpu, &fine, settings, rays)?;
    let of = |(ray, (status, points)): (&[f64; 6], &(Status, Vec<PathPoint>))| {
        // Outside of the bounding sphere there is no medium.
        let ahead = points.first().map_or(0.0, |first| DVec3::from(first.x).distance(DVec3::from_slice(ray)));
        let start = OpticalPath { status: *status, length: ahead, optical: ahead };
        points.windows(2).fold(start, |sum, ends| {
            let [length, optical] = Step::new(&ends[0], &ends[1]).integrals(scene);
            OpticalPath { length: sum.length + length, optical: sum.optical + optical, ..sum }
        })
    };
    Ok(rays.iter().zip(&paths).map(of).collect())
}

/// A step of a path.
struct Step {
    x: [DVec3; 2],
    v: [DVec3; 2],
    time: f64,
}

/// The largest deviation of the velocity at the end of a step from that of a smooth path, relative to the velocity.
const SMOOTH: f64 = 1e-4;

impl Step {
    fn new(start: &PathPoint, end: &PathPoint) -> Self {
        let [x, v] = [[start.x, end.x], [start.v, end.v]].map(|pair| pair.map(DVec3::from));
        Self { x, v, time: end.tau - start.tau }
    }

    /// Returns ∫ n dτ and ∫ n² dτ, with five points.
    fn integrals(&self, scene: &Scene) -> [f64; 2] {
        /// The positions and weights of Gauss and Legendre from 0 to 1.
        const POINTS: [(f64, f64); 5] = [
            (0.046_910_077_030_668, 0.118_463_442_528_094_6),
            (0.230_765_344_947_158_4, 0.239_314_335_249_683_2),
            (0.5, 0.284_444_444_444_444_4),
            (0.769_234_655_052_841_6, 0.239_314_335_249_683_2),
            (0.953_089_922_969_332, 0.118_463_442_528_094_6),
        ];
        let middle = 0.5 * (self.x[0] + self.x[1]);
        let medium = medium_at(scene, middle);
        let squared = |x: DVec3| medium.and_then(|medium| medium.index(x)).map_or(1.0, |n| n * n);
        let path = self.path(&squared);
        POINTS.iter().fold([0.0; 2], |sum, (s, weight)| {
            let place = path.iter().rev().fold(DVec3::ZERO, |sum, term| sum * *s + *term);
            let squared = squared(place);
            [sum[0] + weight * squared.sqrt() * self.time, sum[1] + weight * squared * self.time]
        })
    }

    /// Returns the coefficients of the position as a polynomial of the fraction of the step.
    fn path(&self, squared: &dyn Fn(DVec3) -> f64) -> [DVec3; 6] {
        let [start, end] = self.x;
        let [leaving, arriving] = self.v.map(|v| v * self.time);
        let [first, last] = self.x.map(|x| 0.5 * self.time * self.time * gradient(squared, x));
        // The quartic with the position and acceleration at both ends, and the velocity at the start.
        let rest = end - start - leaving - 0.5 * first;
        let bend = (last - first) / 6.0;
        let (cubic, quartic) = (2.0 * rest - bend, bend - rest);
        let expected = leaving + first + 3.0 * cubic + 4.0 * quartic;
        if (arriving - expected).length() > SMOOTH * leaving.length() {
            return [start, leaving, 0.5 * first, cubic, quartic, DVec3::ZERO];
        }
        let change = end - start;
        [
            start,
            leaving,
            0.5 * first,
            10.0 * change - 6.0 * leaving - 4.0 * arriving - 1.5 * first + 0.5 * last,
            -15.0 * change + 8.0 * leaving + 7.0 * arriving + 1.5 * first - last,
            6.0 * change - 3.0 * (leaving + arriving) - 0.5 * (first - last),
        ]
    }
}

/// Returns the medium at a position: that of the interior of the highest priority, or that of space.
fn medium_at(scene: &Scene, x: DVec3) -> Option<&Arc<dyn Medium>> {
    let inside = scene.objects.iter().filter(|object| object.interior().is_some() && object.contains(x));
    let first = inside.filter_map(|object| object.interior()).max_by_key(|interior| interior.priority);
    let space = scene
        .law
        .facts()
        .medium()
        .filter(|_| scene.rays.bounding_sphere.center.distance(x) <= scene.rays.bounding_sphere.radius);
    first.map(|interior| &interior.medium).or(space)
}

/// Returns the gradient by four-point differences.
fn gradient(of: &dyn Fn(DVec3) -> f64, x: DVec3) -> DVec3 {
    const H: f64 = 1e-3;
    let along = |axis: DVec3| {
        let change = |h: f64| (of(x + h * axis) - of(x - h * axis)) / (2.0 * h);
        (4.0 * change(H) - change(2.0 * H)) / 3.0
    };
    DVec3::new(along(DVec3::X), along(DVec3::Y), along(DVec3::Z))
}
