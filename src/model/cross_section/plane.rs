//! The plane of a diagram, with its position and its right and up directions on paper.

use glam::{DMat3, DVec3};

/// The distance from a plane, relative to the extent of the points, up to which points count as coplanar; larger than `f32` rounding.
const FLAT: f64 = 1e-4;
/// The distance within which a normal snaps to an axis, because a fit to rounded points is never exact.
const SNAP: f64 = 1e-4;

/// A plane with its right and up directions on paper, in scene coordinates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CutPlane {
    /// A point of the plane.
    pub point: DVec3,
    /// The unit vector to the right on paper.
    pub right: DVec3,
    /// The unit vector upwards on paper, perpendicular to `right`.
    pub up: DVec3,
}

impl CutPlane {
    /// Returns the plane through `point` perpendicular to `normal`, or `None` if the normal has no direction. Right and up are as close as
    /// possible to the two axes that are most nearly parallel to the plane, in their usual order: x and y, x and z, or y and z.
    #[must_use]
    pub fn new(point: DVec3, normal: DVec3) -> Option<Self> {
        let normal = snapped(normal.try_normalize()?);
        let steepest = (0..3).rev().fold(2, |k, i| if normal[i].abs() > normal[k].abs() { i } else { k });
        let [a, b] = match steepest {
            0 => [1, 2],
            1 => [0, 2],
            _ => [0, 1],
        };
        let right = DMat3::IDENTITY.col(a).reject_from_normalized(normal).try_normalize()?;
        let up = normal.cross(right);
        let up = if up[b] < 0.0 { -up } else { up };
        // Adding zero removes negative zeros.
        Some(Self { point, right, up: up + DVec3::ZERO })
    }

    /// Returns the only plane that contains all of these points, or `None` if there is none or more than one.
    #[must_use]
    pub fn fit(points: &[DVec3]) -> Option<Self> {
        let middle = points.iter().sum::<DVec3>() / points.len().max(1) as f64;
        let farthest = |from: &dyn Fn(DVec3) -> f64| {
            points.iter().map(|p| *p - middle).max_by(|a, b| from(*a).total_cmp(&from(*b)))
        };
        let along = farthest(&|p| p.length())?;
        let line = along.try_normalize()?;
        let across = farthest(&|p| p.reject_from_normalized(line).length())?.reject_from_normalized(line);
        if across.length() <= FLAT * along.length() {
            return None;
        }
        let plane = Self::new(middle, line.cross(across))?;
        let off = points.iter().map(|p| plane.height(*p).abs()).fold(0.0, f64::max);
        (off <= FLAT * along.length()).then_some(plane)
    }

    /// Returns the unit vector towards the viewer of the paper.
    #[must_use]
    pub fn normal(&self) -> DVec3 {
        self.right.cross(self.up)
    }

    /// Returns the orthogonal projection of a point onto the paper, in scene units; the scene's origin is at [0, 0].
    #[must_use]
    pub fn flat(&self, p: DVec3) -> [f64; 2] {
        [p.dot(self.right), p.dot(self.up)]
    }

    /// Returns the distance of a point in front of the plane.
    #[must_use]
    pub fn height(&self, p: DVec3) -> f64 {
        (p - self.point).dot(self.normal())
    }

    /// Returns the labels of right and up: an axis or a direction.
    #[must_use]
    pub fn names(&self) -> [String; 2] {
        [self.right, self.up].map(|along| {
            match [DVec3::X, DVec3::Y, DVec3::Z].iter().position(|axis| axis.distance(along) < SNAP) {
                Some(axis) => ["x", "y", "z"][axis].to_owned(),
                None => format!("along [{:.2}, {:.2}, {:.2}]", along.x, along.y, along.z),
            }
        })
    }
}

/// Returns the axis that a unit normal is nearly parallel to, or the normal itself.
fn snapped(normal: DVec3) -> DVec3 {
    [DVec3::X, DVec3::Y, DVec3::Z].into_iter().find(|axis| normal.cross(*axis).length() <= SNAP).unwrap_or(normal)
}
