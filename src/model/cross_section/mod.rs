//! Cross sections of surfaces with a plane, which are the outlines of a diagram.
//!
//! *Theory.* An affine map takes planes to planes. Every shape is therefore intersected in its object space, where it is simple, and the
//! outline is mapped back: the outline of a sphere is an ellipse, that of a box a polygon with three to six corners.
//!
//! *Practice.* All computations use 64 bits on the host; a mesh costs one pass over its triangles. Curves are closed polygons of
//! [`CORNERS`] corners, with an error of 2·10⁻⁴ of their radius.

mod convex;
pub(super) mod mesh;
mod plane;

pub(super) use convex::{ON, PARALLEL, cuboid, cylinder, square};
pub use plane::CutPlane;

use std::f64::consts::TAU;

use glam::DVec3;

use super::halved::halved;

/// The number of corners of the polygon that approximates an ellipse.
pub const CORNERS: u32 = 180;

/// A line in which a surface crosses a plane, in scene coordinates.
#[derive(Debug, Clone, PartialEq)]
pub struct Outline {
    /// The points of the line, at least two.
    pub points: Vec<DVec3>,
    /// Is `true` if the last point is joined to the first.
    pub closed: bool,
}

/// A plane n · y = d in the object space of a shape.
#[derive(Debug, Clone, Copy)]
pub struct LocalPlane {
    /// The unit normal n.
    pub normal: DVec3,
    /// The offset d from the origin.
    pub offset: f64,
}

impl LocalPlane {
    /// Returns the scene's plane n · (x − p) = 0 under x = M y + t, which is Mᵀn · y = n · (p − t).
    pub(super) fn of(plane: &CutPlane, transposed: glam::DMat3, translation: DVec3) -> Option<Self> {
        let normal = transposed * plane.normal();
        let length = normal.length();
        let offset = plane.normal().dot(plane.point - translation) / length;
        let own = Self { normal: normal / length, offset };
        (own.normal.is_finite() && offset.is_finite()).then_some(own)
    }
}

/// Returns a circle around a center, in the plane perpendicular to a unit normal.
#[must_use]
pub fn circle(center: DVec3, normal: DVec3, radius: f64) -> Outline {
    let (a, b) = normal.any_orthonormal_pair();
    let corner = |i: u32| {
        let (sin, cos) = (TAU * f64::from(i) / f64::from(CORNERS)).sin_cos();
        center + radius * (cos * a + sin * b)
    };
    Outline { points: (0..CORNERS).map(corner).collect(), closed: true }
}

/// Returns the outline of a region in a plane, or `None` if the point of the plane nearest to the center is outside. The region must be
/// within `radius` of the center.
#[must_use]
pub fn star_in_plane(center: DVec3, radius: f64, inside: &dyn Fn(DVec3) -> bool, plane: &CutPlane) -> Option<Outline> {
    const LOOKS: u32 = 64;
    const HALVINGS: u32 = 40;
    let foot = center - plane.height(center) * plane.normal();
    let corner = |i: u32| {
        let (sin, cos) = (TAU * f64::from(i) / f64::from(CORNERS)).sin_cos();
        let way = cos * plane.right + sin * plane.up;
        let at = |k: u32| radius * f64::from(k) / f64::from(LOOKS);
        let is_inside = |distance: f64| inside(foot + distance * way);
        let last = (0..LOOKS).rev().find(|k| is_inside(at(*k))).unwrap_or(0);
        foot + halved(at(last), at(last + 1), HALVINGS, |distance| !is_inside(distance))[0] * way
    };
    inside(foot).then(|| Outline { points: (0..CORNERS).map(corner).collect(), closed: true })
}

/// Returns the circle in which a sphere crosses a plane, or `None` if they do not cross.
#[must_use]
pub fn sphere_in_plane(center: DVec3, radius: f64, plane: &CutPlane) -> Option<Outline> {
    let height = plane.height(center);
    let within = (radius * radius - height * height).sqrt();
    let middle = center - height * plane.normal();
    (within > 0.0).then(|| circle(middle, plane.normal(), within))
}
