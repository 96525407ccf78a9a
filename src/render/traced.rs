//! Stores the end of a followed ray.

use glam::DVec3;

use super::Status;

/// The end of a ray.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Traced {
    /// The termination status.
    pub status: Status,
    /// The position.
    pub x: [f64; 3],
    /// The velocity.
    pub v: [f64; 3],
    /// The path parameter τ.
    pub tau: f64,
    /// The number of segments, including a fraction of the last one.
    pub segments: f64,
    /// The number of accepted steps.
    pub steps: u32,
    /// The number of rejected steps.
    pub rejected: u32,
    /// The index of the scene's object that was hit, if any.
    pub object: Option<u32>,
}

impl Traced {
    /// Returns the angle between this ray's direction and another's, in radians.
    #[must_use]
    pub fn angle_to(&self, other: &Self) -> f64 {
        let (a, b) = (DVec3::from(self.v), DVec3::from(other.v));
        a.cross(b).length().atan2(a.dot(b))
    }

    /// Returns the distance between this ray's end and another's.
    #[must_use]
    pub fn distance_to(&self, other: &Self) -> f64 {
        DVec3::from(self.x).distance(other.x.into())
    }

    /// Returns the magnitude of the velocity.
    #[must_use]
    pub fn speed(&self) -> f64 {
        DVec3::from(self.v).length()
    }
}

/// The end of a segment on a path; the first point is the start of the path.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PathPoint {
    /// The position.
    pub x: [f64; 3],
    /// The velocity.
    pub v: [f64; 3],
    /// The path parameter τ.
    pub tau: f64,
}
