//! The Jacobian of a ray: how its end changes with the direction at its start.
//!
//! *Theory.* A ray starts in the direction d with two perpendicular axes a₁ and a₂, all in the frame of a static observer in curved
//! spacetime. Neighboring rays start in d + α a₁ + β a₂. The Jacobian has the derivatives of the direction at the end, and those of the
//! position, by α and β, each along two axes b₁ and b₂ that are perpendicular to the ray at its end. The magnification of a distant
//! source is the ratio of the solid angles at the start and at the end, 1/det, and its sign is the parity of the image.
//!
//! *Practice.* Derivatives are four-point differences between rays. First, two very close pairs of neighbors determine how fast the end
//! changes; then the distance of the others is chosen so that their ends are a small distance apart, because strong lenses magnify every
//! difference, and the rounding error of their starts too. The axes are a₁ ∝ z × d and a₂ = d × a₁, with x instead of z along z, and likewise at the end.

use glam::{DMat2, DVec2, DVec3, DVec4};

use crate::gpu::Gpu;
use crate::model::camera::frame;
use crate::model::{Law, Observer};
use crate::render::{RenderError, RenderSettings, Status, Totals, Traced, trace};
use crate::scene::{Precision, Scene};

/// The derivatives of a ray's end by the direction at its start, in radians: columns by a₁ and a₂, rows along b₁ and b₂.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Jacobian {
    /// The derivatives of the direction, in radians per radian.
    pub direction: DMat2,
    /// The derivatives of the position, in scene units per radian.
    pub position: DMat2,
}

impl Jacobian {
    /// Returns the magnification of a source at a great distance, negative if its image is mirrored.
    #[must_use]
    pub fn magnification(&self) -> f64 {
        1.0 / self.direction.determinant()
    }
}

/// The end of a ray, with its Jacobian if it has one.
pub type EndJacobian = (Traced, Option<Jacobian>);

/// Follows `rays` and their neighbors, and returns the end and the Jacobian of each with the totals of the rays themselves. A ray has no Jacobian if it
/// or a close neighbor does not end in the same way, or if there is no static observer at its start.
///
/// # Errors
///
/// Returns the errors of [`trace`].
pub fn jacobians(
    gpu: &Gpu,
    scene: &Scene,
    settings: &RenderSettings,
    rays: &[[f64; 6]],
) -> Result<(Vec<EndJacobian>, Totals), RenderError> {
    let (ends, totals) = trace(gpu, scene, settings, rays)?;
    let is_double = scene.rays.precision == Precision::Double;
    let (close, apart) = if is_double { (1e-6, 2e-3) } else { (1e-4, 2e-2) };
    let fans: Vec<Option<Fan>> = rays.iter().zip(&ends).map(|(ray, end)| Fan::new(&*scene.law, ray, end)).collect();
    let differences = |offsets: &[Option<f64>], steps: &[f64]| -> Result<Vec<Option<Jacobian>>, RenderError> {
        let each = 4 * steps.len();
        let chosen = || fans.iter().zip(offsets).map(|(fan, offset)| fan.as_ref().zip(*offset));
        let neighbors = chosen().flatten().flat_map(|(fan, offset)| fan.neighbors(offset, steps));
        let (found, _) = trace(gpu, scene, settings, &neighbors.collect::<Vec<_>>())?;
        let mut found = found.chunks(each);
        let of = |one: Option<(&Fan, f64)>| one.and_then(|(fan, offset)| fan.jacobian(offset, steps, found.next()?));
        Ok(chosen().map(of).collect())
    };
    let rough = differences(&vec![Some(close); rays.len()], &[1.0])?;
    let missing: Vec<Option<f64>> = rough.iter().map(|one| one.is_none().then_some(0.01 * close)).collect();
    let closer = differences(&missing, &[1.0])?;
    // The error of the starts, ε D/h, and that of the differences, h⁴, are balanced by h ∝ D^(1/5) for ends that are h apart.
    let offset = |one: &Jacobian| {
        let steepest = one.direction.to_cols_array().into_iter().fold(1.0, |a: f64, b| a.max(b.abs()));
        apart * steepest.powf(-0.8)
    };
    let offsets: Vec<Option<f64>> =
        rough.iter().zip(&closer).map(|(rough, closer)| rough.as_ref().or(closer.as_ref()).map(offset)).collect();
    let fine = differences(&offsets, &[1.0, 2.0])?;
    let found = fine.into_iter().zip(rough).map(|(fine, rough)| fine.or(rough));
    Ok((ends.into_iter().zip(found).collect(), totals))
}

/// A ray with the axes at its start and at its end.
struct Fan {
    x: DVec3,
    /// The velocity, and its changes along a₁ and a₂.
    v: [DVec3; 3],
    /// The status and the object of the end.
    end: (Status, Option<u32>),
    axes: [DVec3; 2],
}

impl Fan {
    fn new(law: &dyn Law, ray: &[f64; 6], end: &Traced) -> Option<Self> {
        let [x, v] = [DVec3::from_slice(&ray[..3]), DVec3::from_slice(&ray[3..])];
        if !matches!(end.status, Status::Hit | Status::Escaped | Status::Ended) {
            return None;
        }
        let d = v.try_normalize()?;
        let [right, up] = across(d);
        // In curved spacetime the direction of light in space follows from the observer's axes, up to a factor.
        let v = match law.metric(x, 0.0) {
            Some(_) => frame(law, x, Observer::Static, [right, up, d])?.map(DVec4::truncate),
            None => [right, up, d].map(|axis| v.length() * axis),
        };
        let [right, up, forward] = v;
        let axes = across(DVec3::from(end.v).try_normalize()?);
        Some(Self { x, v: [forward, right, up], end: (end.status, end.object), axes })
    }

    /// Returns the neighbors on both sides along both axes, at multiples of an offset.
    fn neighbors(&self, offset: f64, steps: &[f64]) -> Vec<[f64; 6]> {
        let [forward, right, up] = self.v;
        let along = |axis: DVec3, by: f64| {
            let v = (forward + by * axis).normalize() * forward.length();
            [self.x.x, self.x.y, self.x.z, v.x, v.y, v.z]
        };
        let pair = |axis: DVec3, by: f64| [along(axis, by), along(axis, -by)];
        steps.iter().flat_map(|step| [right, up].map(|axis| pair(axis, step * offset))).flatten().collect()
    }

    /// Returns the derivatives from the ends of the neighbors.
    fn jacobian(&self, offset: f64, steps: &[f64], ends: &[Traced]) -> Option<Jacobian> {
        if ends.iter().any(|end| (end.status, end.object) != self.end) {
            return None;
        }
        let difference = |of: &dyn Fn(&Traced) -> DVec3, pair: &[Traced], step: f64| {
            let change = (of(&pair[0]) - of(&pair[1])) / (2.0 * step * offset);
            DVec2::from(self.axes.map(|axis| axis.dot(change)))
        };
        let derivative = |of: &dyn Fn(&Traced) -> DVec3| {
            let columns = [0, 2].map(|first: usize| {
                let at = |k: usize| difference(of, &ends[4 * k + first..4 * k + first + 2], steps[k]);
                // Two distances, 1 and 2, cancel the error of third order.
                if steps.len() == 2 { (4.0 * at(0) - at(1)) / 3.0 } else { at(0) }
            });
            DMat2::from_cols(columns[0], columns[1])
        };
        Some(Jacobian {
            direction: derivative(&|end| DVec3::from(end.v).normalize()),
            position: derivative(&|end| DVec3::from(end.x)),
        })
    }
}

/// Returns two unit vectors that are perpendicular to a unit vector and to each other, in the order of a right-handed system.
fn across(d: DVec3) -> [DVec3; 2] {
    let first = DVec3::Z.cross(d).try_normalize().filter(|_| d.z.abs() < 1.0 - 1e-12);
    let first = first.unwrap_or_else(|| DVec3::X.cross(d).normalize());
    [first, d.cross(first)]
}
