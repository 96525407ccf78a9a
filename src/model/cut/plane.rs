//! A plane to look at a scene in: where it is, and what is right and up on paper.

use glam::{DMat3, DVec3};

/// Points may be off a plane by this part of their extent and still count as in it: more than the roundings of `f32`.
const FLAT: f64 = 1e-4;
/// Normals this near to an axis are that axis: a fit to rounded points is never exact.
const SNAP: f64 = 1e-4;

/// A plane with its directions on paper, in scene coordinates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CutPlane {
    /// A point of it.
    pub point: DVec3,
    /// Unit vector to the right on paper.
    pub right: DVec3,
    /// Unit vector upwards on paper, perpendicular to `right`.
    pub up: DVec3,
}

impl CutPlane {
    /// The plane through `point` perpendicular to `normal`; none if that has no direction. Right and up are as near as can be
    /// to the two axes that the plane runs along most, in their usual order: x and y, x and z, or y and z.
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
        // Without the signs of zeros.
        Some(Self { point, right, up: up + DVec3::ZERO })
    }

    /// The plane in which all of these points lie, if there is one and only one.
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

    /// Unit vector towards whoever looks at the paper.
    #[must_use]
    pub fn normal(&self) -> DVec3 {
        self.right.cross(self.up)
    }

    /// A point's place on paper: its shadow there. Distances are those of the scene, and the scene's origin is at [0, 0].
    #[must_use]
    pub fn flat(&self, p: DVec3) -> [f64; 2] {
        [p.dot(self.right), p.dot(self.up)]
    }

    /// How far a point is in front of the plane.
    #[must_use]
    pub fn height(&self, p: DVec3) -> f64 {
        (p - self.point).dot(self.normal())
    }

    /// What right and up are called: an axis, or a direction.
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

/// The axis that a unit normal is as good as, or itself.
fn snapped(normal: DVec3) -> DVec3 {
    [DVec3::X, DVec3::Y, DVec3::Z].into_iter().find(|axis| normal.cross(*axis).length() <= SNAP).unwrap_or(normal)
}
