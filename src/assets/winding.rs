//! Winding numbers: the number of times that a closed mesh surrounds a point.
//!
//! *Theory.* The winding number is the sum of the triangles' solid angles as seen from the point, over 4π (Jacobson, Kavan
//! and Sorkine-Hornung 2013). No ray needs to choose between edges, and rounding errors are far below the ½ that decides.
//!
//! *Practice.* This is for single points on the host, such as the camera's position: it takes an arctangent per triangle.

use glam::DVec3;

use super::Mesh;

impl Mesh {
    /// Returns the number of times that the surface surrounds a point in object space, positive if its
    /// triangles are counter-clockwise as seen from outside: an integer if the mesh is closed, 0 outside.
    #[must_use]
    pub fn winding(&self, x: DVec3) -> f64 {
        let corner = |i: u32| self.vertices[i as usize].position.as_dvec3() - x;
        let angles = self.triangles.iter().map(|t| solid_angle(t.map(corner)));
        angles.sum::<f64>() / (4.0 * std::f64::consts::PI)
    }
}

/// Returns the signed solid angle of a triangle as seen from the origin (Van Oosterom and Strackee 1983, Eq. 8).
fn solid_angle([a, b, c]: [DVec3; 3]) -> f64 {
    let (la, lb, lc) = (a.length(), b.length(), c.length());
    let above = a.dot(b.cross(c));
    let below = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
    2.0 * above.atan2(below)
}
