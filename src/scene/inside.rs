//! What is inside an object, and how far from its surface a point is.
//!
//! *Theory.* An analytic shape is where a few functions of its own coordinates are below 0, one for each of its faces; the
//! distance from a face is, to first order, the function over the length of its gradient in the scene. A closed mesh is
//! where its winding number is not 0: the solid angles of its triangles as seen from the point, over 4π (Jacobson, Kavan and
//! Sorkine-Hornung 2013). No ray has to choose between edges that it meets, and rounding is far from the ½ that decides.
//!
//! *Practice.* For single points on the host, such as the camera's place: a mesh costs an arctangent for each triangle.

use super::{Mesh, Object, Shape};
use glam::DVec3;

impl Shape {
    /// Has it an inside?
    #[must_use]
    pub fn is_closed(&self) -> bool {
        match self {
            Self::Sphere | Self::Box | Self::Cylinder => true,
            Self::Plane | Self::Disk { .. } => false,
            Self::Mesh(mesh) => mesh.hole().is_none(),
        }
    }
}

impl Object {
    /// Is this point of the scene inside? Planes, disks and meshes that are not closed have no inside; the surface itself is
    /// outside for analytic shapes, and either for meshes.
    #[must_use]
    pub fn contains(&self, x: DVec3) -> bool {
        let own = self.transform.0.inverse().transform_point3(x);
        match &self.shape {
            Shape::Mesh(mesh) => mesh.hole().is_none() && mesh.winding(own).abs() > 0.5,
            shape => faces(shape, own).is_some_and(|faces| faces.iter().all(|(value, _)| *value < 0.0)),
        }
    }

    /// The signed distance of this point of the scene from the surface, in scene units, to first order: negative inside. None
    /// for planes, disks and meshes. It is exact for spheres, inside boxes, and inside cylinders that are round.
    #[must_use]
    pub fn gap(&self, x: DVec3) -> Option<f64> {
        let inverse = self.transform.0.inverse();
        let to_scene = inverse.matrix3.transpose();
        let gaps = faces(&self.shape, inverse.transform_point3(x))?;
        let gaps = gaps.iter().map(|(value, gradient)| value / (to_scene * *gradient).length());
        gaps.reduce(f64::max)
    }
}

/// For each kind of face a function that is below 0 inside, and its gradient, a unit vector; both in the shape's own space.
fn faces(shape: &Shape, p: DVec3) -> Option<Vec<(f64, DVec3)>> {
    // On the axis every direction away from it is as good.
    let round = |q: DVec3| (q.length() - 1.0, q.normalize_or(DVec3::X));
    let flat = |coordinate: f64, axis: DVec3| (coordinate.abs() - 1.0, axis);
    match shape {
        Shape::Sphere => Some(vec![round(p)]),
        Shape::Box => Some(vec![flat(p.x, DVec3::X), flat(p.y, DVec3::Y), flat(p.z, DVec3::Z)]),
        Shape::Cylinder => Some(vec![round(DVec3::new(p.x, 0.0, p.z)), flat(p.y, DVec3::Y)]),
        Shape::Plane | Shape::Disk { .. } | Shape::Mesh(_) => None,
    }
}

impl Mesh {
    /// How often the surface goes round a point of its own space, counted where its triangles wind counter-clockwise as seen
    /// from outside: a whole number where the mesh is closed, 0 outside.
    #[must_use]
    pub fn winding(&self, x: DVec3) -> f64 {
        let corner = |i: u32| self.vertices[i as usize].position.as_dvec3() - x;
        let angles = self.triangles.iter().map(|t| solid_angle(t.map(corner)));
        angles.sum::<f64>() / (4.0 * std::f64::consts::PI)
    }
}

/// The signed solid angle of a triangle as seen from the origin: Van Oosterom and Strackee 1983, Eq. 8.
fn solid_angle([a, b, c]: [DVec3; 3]) -> f64 {
    let (la, lb, lc) = (a.length(), b.length(), c.length());
    let above = a.dot(b.cross(c));
    let below = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
    2.0 * above.atan2(below)
}
