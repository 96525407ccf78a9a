//! Winding numbers: how often a closed mesh goes round a point.
//!
//! *Theory.* They are the solid angles of its triangles as seen from the point, over 4π (Jacobson, Kavan and Sorkine-Hornung 2013). No
//! ray has to choose between edges that it meets, and rounding is far from the ½ that decides.
//!
//! *Practice.* For single points on the host, such as the camera's place: an arctangent for each triangle.

use glam::DVec3;

use super::Mesh;

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
