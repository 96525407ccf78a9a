//! Shapes: what objects are, each in its own space. The contract, and the table of kinds.
//!
//! *Theory.* A shape stands in a space of its own, where it is simple: an affine map places it in the scene. In WGSL a *solid* is a
//! shape as the shaders test it: `hit_SOLID`, and where rays go on through it `cross_SOLID`; one kind may be several (a sphere that is
//! stretched is an ellipsoid).
//!
//! *Practice.* [`KINDS`] names each kind once, [`SOLIDS`] each solid. Adding one is a WGSL file, a file here and a line of each.

mod contact;
mod cuboid;
mod cylinder;
mod disk;
mod extent;
mod mesh;
mod object;
mod plane;
mod read;
mod solid;
mod sphere;
mod travel;

use std::fmt;
use std::sync::Arc;

use glam::{DAffine3, DVec3};

use super::Same;
use super::cut::{Outline, OwnPlane};
use super::medium::Surroundings;
use super::same::same;
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
pub(crate) use read::read;
pub use solid::{Placed, Solid};
pub use sphere::Sphere;
pub use travel::Travel;

/// Reads a shape, with the map from its own space that its keys make; none if it cannot be used. `across` is twice the radius of
/// the bounding sphere.
type Read = fn(&TableReader, across: f64, &mut Files) -> Option<(Arc<dyn Shape>, DAffine3)>;
type Kind = document::Kind<Read>;

/// Every kind of shape. Adding one is a line here.
pub static KINDS: Kinds<Read> = Kinds {
    table: "objects",
    chooser: "shape",
    meaning: "shape of the object",
    example: Some("sphere"),
    all: &[&sphere::KIND, &plane::KIND, &cuboid::KIND, &cylinder::KIND, &disk::KIND, &mesh::KIND],
};

/// Every solid, by name.
pub const SOLIDS: [&Solid; 7] =
    [&cuboid::SOLID, &cylinder::SOLID, &disk::SOLID, &sphere::ELLIPSOID, &plane::SOLID, &sphere::SOLID, &mesh::SOLID];

/// A shape in its own space, where its size is about 1.
pub trait Shape: fmt::Debug + Send + Sync + Same {
    /// What the shaders test, in this place.
    fn solid(&self, place: &Transform) -> &'static Solid;

    /// The number that its solid has besides a place: a radius, or that of a hole.
    fn number(&self, place: &Transform) -> f64 {
        let _ = place;
        0.0
    }

    /// Its triangles, if it is made of them.
    fn mesh(&self) -> Option<&Arc<Mesh>> {
        None
    }

    /// For each kind of face a function that is below 0 inside, and its gradient, a unit vector. None if the shape has no inside.
    fn faces(&self, p: DVec3) -> Vec<(f64, DVec3)> {
        let _ = p;
        Vec::new()
    }

    /// Is this point of its space inside? The surface itself is outside, or for meshes either.
    fn contains(&self, p: DVec3) -> bool {
        let faces = self.faces(p);
        !faces.is_empty() && faces.iter().all(|(value, _)| *value < 0.0)
    }

    /// Is this point of its space no farther than `slack` from the surface?
    fn near_surface(&self, p: DVec3, slack: f64) -> bool {
        self.faces(p).into_iter().map(|(value, _)| value).reduce(f64::max).is_some_and(|value| value.abs() <= slack)
    }

    /// Returns why light cannot go through it, if it cannot: it has no inside, or a ray may cross it more than once. What tests clear
    /// shapes knows one entry and one exit of each, except for meshes, whose triangles it counts.
    fn refuses_interior(&self) -> Option<String> {
        None
    }

    /// Returns the shapes that stand for it if rays are on one of its sides, because its own surface does not say which side is
    /// inside, or is around some points more than once. Returns none if the shape can be used itself.
    fn solids(&self) -> Vec<Arc<dyn Shape>> {
        Vec::new()
    }

    /// The parts of its surface, placed by a map, by which it may lie on others.
    fn contacts(&self, map: DAffine3) -> Vec<Contact>;

    /// The greatest distance from `center` to a point of it, placed by a map; none where it may reach beyond the bound.
    fn reach(&self, map: DAffine3, center: DVec3) -> Option<f64>;

    /// The radius of a ball about the origin that holds all of it.
    fn radius(&self) -> f64;

    /// Where its surface crosses a plane. A surface that lies in the plane shows its edge.
    fn cut(&self, plane: OwnPlane) -> Vec<Outline>;

    /// The length of a vector in the norm whose unit ball it is; for shapes with an inside.
    fn norm(&self, d: DVec3) -> f64 {
        d.length()
    }

    /// A box about it, placed by a map: lower and upper corner.
    fn bounds(&self, map: DAffine3) -> (DVec3, DVec3) {
        // A transformed cube's half extents; they bound what is in it.
        let m = map.matrix3;
        let half = m.x_axis.abs() + m.y_axis.abs() + m.z_axis.abs();
        (map.translation - half, map.translation + half)
    }

    /// What a medium in it takes its place and size from.
    fn surroundings(&self, place: &Transform) -> Surroundings {
        Surroundings { center: place.0.translation, ..Surroundings::default() }
    }

    /// Its radius, if it is a ball there.
    fn ball_radius(&self, place: &Transform) -> Option<f64> {
        let _ = place;
        None
    }

    /// Is a ball wholly inside, as far as that is known?
    fn holds_ball(&self, place: &Transform, center: DVec3, radius: f64) -> bool {
        let _ = (place, center, radius);
        false
    }

    /// The radius of the largest ball about a point that is inside; 0 where that is not known.
    fn ball_inside(&self, place: &Transform, center: DVec3) -> f64 {
        let _ = (place, center);
        0.0
    }

    /// A ball about the part of it that is in another ball, seen from `middle`; none if there is no such part.
    fn ball_in_ball(&self, place: &Transform, middle: DVec3, center: DVec3, radius: f64) -> Option<(DVec3, f64)> {
        let _ = (middle, center, radius);
        Some(ball(self.radius(), place))
    }
}

/// The ball of this radius about the origin, placed.
fn ball(radius: f64, place: &Transform) -> (DVec3, f64) {
    let m = place.0.matrix3;
    let stretch = [m.x_axis, m.y_axis, m.z_axis].into_iter().map(DVec3::length).fold(0.0, f64::max);
    (place.0.translation, radius * stretch)
}

same!(Shape);

/// `center`.
const CENTER: Key = keys! { center: "[x, y, z]" = "[0, 0, 0]", "center, in scene units"; }[0];
/// `radius`.
const RADIUS: Key = keys! { radius: "number above 0" = "1", "scene units"; }[0];
/// `normal`.
const NORMAL: Key = keys! { normal: "[x, y, z]" = "[0, 1, 0]", "direction of the surface normal"; }[0];
