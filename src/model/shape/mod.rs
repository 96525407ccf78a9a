//! Shapes, which define the geometry of objects in object space: the contract and the table of kinds.
//!
//! *Theory.* A shape is defined in object space, where it is simple, and an affine map places it in the scene. In WGSL, a *solid* is the
//! form of a shape that shaders test: `hit_SOLID`, and `cross_SOLID` if rays continue through it. One kind may have several solids (a
//! stretched sphere is an ellipsoid).
//!
//! *Practice.* [`KINDS`] lists each kind once, [`SOLIDS`] each solid. To add one, add a WGSL file, a file here and a line of each.

mod contact;
mod cuboid;
mod cylinder;
mod disk;
mod extent;
mod mesh;
mod object;
mod plane;
mod primitive;
mod read;
mod rigid_motion;
mod sphere;

use std::fmt;
use std::sync::Arc;

use glam::{DAffine3, DVec3};

use super::DynEq;
use super::cross_section::{LocalPlane, Outline};
use super::dyn_eq::same;
use super::medium::Surroundings;
use crate::assets::{Files, Mesh, Transform};
use crate::document::reader::TableReader;
use crate::document::{self, Key, Kinds, keys};

pub use contact::Contact;
pub use cuboid::Cuboid;
pub use cylinder::Cylinder;
pub use disk::Disk;
pub use extent::round_up;
pub use mesh::Triangles;
pub use object::{Object, Substance};
pub use plane::Plane;
pub use primitive::{Placed, Primitive};
pub(crate) use read::read;
pub use rigid_motion::RigidMotion;
pub use sphere::Sphere;

/// Reads a shape, with the map from object space that its keys define; returns `None` after an error. `across` is the diameter of the
/// bounding sphere.
type Read = fn(&TableReader, across: f64, &mut Files) -> Option<(Arc<dyn Shape>, DAffine3)>;
type Kind = document::Kind<Read>;

/// The table of all shapes; a new kind needs one line here.
pub static KINDS: Kinds<Read> = Kinds {
    table: "objects",
    chooser: "shape",
    meaning: "shape of the object",
    example: Some("sphere"),
    all: &[&sphere::KIND, &plane::KIND, &cuboid::KIND, &cylinder::KIND, &disk::KIND, &mesh::KIND],
};

/// The solids, by name.
pub const SOLIDS: [&Primitive; 7] =
    [&cuboid::SOLID, &cylinder::SOLID, &disk::SOLID, &sphere::ELLIPSOID, &plane::SOLID, &sphere::SOLID, &mesh::SOLID];

/// A shape in object space, where its size is about 1.
pub trait Shape: fmt::Debug + Send + Sync + DynEq {
    /// Returns the solid that shaders test after this placement.
    fn solid(&self, place: &Transform) -> &'static Primitive;

    /// Returns the number that the solid needs in addition to its placement, such as a radius or the inner radius of a disk.
    fn number(&self, place: &Transform) -> f64 {
        let _ = place;
        0.0
    }

    /// Returns the triangles of a mesh.
    fn mesh(&self) -> Option<&Arc<Mesh>> {
        None
    }

    /// Returns one function for each kind of face, negative inside, with its gradient as a unit vector; empty if the shape has no inside.
    fn faces(&self, p: DVec3) -> Vec<(f64, DVec3)> {
        let _ = p;
        Vec::new()
    }

    /// Returns `true` if a point of object space is inside. Surface points are outside, except for meshes, where they may be either.
    fn contains(&self, p: DVec3) -> bool {
        let faces = self.faces(p);
        !faces.is_empty() && faces.iter().all(|(value, _)| *value < 0.0)
    }

    /// Returns `true` if a point of object space is within `slack` of the surface.
    fn near_surface(&self, p: DVec3, slack: f64) -> bool {
        self.faces(p).into_iter().map(|(value, _)| value).reduce(f64::max).is_some_and(|value| value.abs() <= slack)
    }

    /// Returns why the shape cannot have an interior: it has no inside, or a ray may cross it more than once. The test of transparent
    /// shapes supports one entry and one exit, except for meshes, where it counts triangles.
    fn refuses_interior(&self) -> Option<String> {
        None
    }

    /// Returns the shapes that replace it if rays track their side, because its surface does not define an inside or encloses some points
    /// more than once. Returns none if the shape can be used unchanged.
    fn solids(&self) -> Vec<Arc<dyn Shape>> {
        Vec::new()
    }

    /// Returns the faces of the mapped surface that may coincide with others.
    fn contacts(&self, map: DAffine3) -> Vec<Contact>;

    /// Returns the greatest distance from `center` to a point of the mapped shape, or `None` if it may extend beyond the bounding sphere.
    fn reach(&self, map: DAffine3, center: DVec3) -> Option<f64>;

    /// Returns the radius of a bounding sphere around the origin of object space.
    fn radius(&self) -> f64;

    /// Returns the lines in which the surface crosses a plane, or its edge if it is in the plane.
    fn cut(&self, plane: LocalPlane) -> Vec<Outline>;

    /// Returns the length of a vector in the norm whose unit ball is the shape; for shapes with an inside.
    fn norm(&self, d: DVec3) -> f64 {
        d.length()
    }

    /// Returns the lower and upper corner of a bounding box of the mapped shape.
    fn bounds(&self, map: DAffine3) -> (DVec3, DVec3) {
        // The half extents of the transformed cube bound its contents.
        let m = map.matrix3;
        let half = m.x_axis.abs() + m.y_axis.abs() + m.z_axis.abs();
        (map.translation - half, map.translation + half)
    }

    /// Returns the defaults of position and size for a medium in the shape.
    fn surroundings(&self, place: &Transform) -> Surroundings {
        Surroundings { center: place.0.translation, ..Surroundings::default() }
    }

    /// Returns the radius if the placed shape is a ball.
    fn ball_radius(&self, place: &Transform) -> Option<f64> {
        let _ = place;
        None
    }

    /// Returns `true` if a ball is certainly inside.
    fn holds_ball(&self, place: &Transform, center: DVec3, radius: f64) -> bool {
        let _ = (place, center, radius);
        false
    }

    /// Returns the radius of the largest known ball inside the shape around a point; 0 if unknown.
    fn ball_inside(&self, place: &Transform, center: DVec3) -> f64 {
        let _ = (place, center);
        0.0
    }

    /// Returns a bounding sphere of the shape's intersection with another ball, as seen from `middle`, or `None` if there is no
    /// intersection.
    fn ball_in_ball(&self, place: &Transform, middle: DVec3, center: DVec3, radius: f64) -> Option<(DVec3, f64)> {
        let _ = (middle, center, radius);
        Some(ball(self.radius(), place))
    }
}

/// Returns the placed ball of this radius around the origin.
fn ball(radius: f64, place: &Transform) -> (DVec3, f64) {
    let m = place.0.matrix3;
    let stretch = [m.x_axis, m.y_axis, m.z_axis].into_iter().map(DVec3::length).fold(0.0, f64::max);
    (place.0.translation, radius * stretch)
}

same!(Shape);

/// The key `center`.
const CENTER: Key = keys! { center: "[x, y, z]" = "[0, 0, 0]", "the center of the shape, in scene units"; }[0];
/// The key `radius`.
const RADIUS: Key = keys! { radius: "number above 0" = "1", "scene units"; }[0];
/// The key `normal`.
const NORMAL: Key = keys! { normal: "[x, y, z]" = "[0, 1, 0]", "direction of the normal"; }[0];
