//! What is told of a ray that was followed.

use glam::DVec3;

use super::Status;

/// Where a ray ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Traced {
    /// How.
    pub status: Status,
    /// Position.
    pub x: [f64; 3],
    /// Velocity.
    pub v: [f64; 3],
    /// The path's parameter.
    pub tau: f64,
    /// Segments, whole ones and a fraction.
    pub depth: f64,
    /// Accepted steps.
    pub steps: u32,
    /// Rejected tries.
    pub rejected: u32,
    /// Index into the scene's objects, if one was hit.
    pub object: Option<u32>,
}

impl Traced {
    /// The angle between this ray's direction and another's, in radians.
    #[must_use]
    pub fn angle_to(&self, other: &Self) -> f64 {
        let (a, b) = (DVec3::from(self.v), DVec3::from(other.v));
        a.cross(b).length().atan2(a.dot(b))
    }

    /// Between this ray's end and another's.
    #[must_use]
    pub fn distance_to(&self, other: &Self) -> f64 {
        DVec3::from(self.x).distance(other.x.into())
    }

    /// The size of its velocity.
    #[must_use]
    pub fn speed(&self) -> f64 {
        DVec3::from(self.v).length()
    }
}

/// A segment's end along a path; the first is the path's start.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PathPoint {
    /// Position.
    pub x: [f64; 3],
    /// Velocity.
    pub v: [f64; 3],
    /// The path's parameter.
    pub tau: f64,
}
