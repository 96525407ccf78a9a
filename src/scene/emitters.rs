//! The emissive surfaces that next-event estimation samples.

use glam::{DAffine3, DMat3, DVec3};

use super::{Object, Scene};
use crate::model::{Row, row};

/// The bounding volumes of an emissive surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Emitter {
    /// The index of the object.
    pub object: usize,
    /// The center of both.
    pub center: DVec3,
    /// The radius of the sphere.
    pub radius: f64,
    /// Half the edges of the box, as columns; `None` if the sphere is tighter.
    pub edges: Option<DMat3>,
    /// The area of its disk times the mean radiance.
    pub power: f64,
}

/// The largest number of sampled emitters, because each adds a few operations to every vertex.
const MOST: usize = 64;

impl Emitter {
    /// Returns the members for `shaders/path/light_sampling/emitters.wgsl`.
    pub(crate) fn row(self) -> Row {
        let edges = self.edges.unwrap_or(DMat3::ZERO);
        let rows = self.edges.map_or(DMat3::ZERO, |edges| edges.inverse().transpose());
        row! {
            center: Vec3(self.center),
            radius: Float(self.radius),
            edge_x: Vec3(edges.x_axis),
            power: Float(self.power),
            edge_y: Vec3(edges.y_axis),
            volume: Float(8.0 * edges.determinant().abs()),
            edge_z: Vec3(edges.z_axis),
            row_x: Vec3(rows.x_axis),
            row_y: Vec3(rows.y_axis),
            row_z: Vec3(rows.z_axis),
        }
    }
}

impl Scene {
    /// Returns the sampled emitters in the order of the file, limited to the 64 brightest. Paths hit other emitters by chance.
    #[must_use]
    pub fn emitters(&self) -> Vec<Emitter> {
        if !self.rays.path_tracing.is_some_and(|paths| paths.light_sampling) {
            return Vec::new();
        }
        let emitter = |(i, object): (usize, &super::Object)| {
            let material = self.material_of(object)?;
            let mesh = object.shape.mesh().filter(|_| material.color.has_vertex_colors());
            let vertex_color = mesh.map_or(DVec3::ONE, |mesh| mesh.mean_color());
            let radiance = material.surface.emission(vertex_color * material.color.mean(&self.pictures));
            let mean = radiance.element_sum() / 3.0;
            let (center, radius, edges) = volumes(object);
            let power = mean * std::f64::consts::PI * radius * radius;
            let aimed_at = material.surface.facts().is_aimed_at && mean > 0.0;
            aimed_at.then_some(Emitter { object: i, center, radius, edges, power })
        };
        let mut all: Vec<Emitter> = self.objects.iter().enumerate().filter_map(emitter).collect();
        all.sort_by(|a, b| b.power.total_cmp(&a.power));
        all.truncate(MOST);
        all.sort_by_key(|emitter| emitter.object);
        all
    }
}

/// The least edge of a box, as a fraction of its longest one, and the fraction by which it exceeds the surface: rays to the edge of the
/// surface hit the box whatever rounding does to them.
const SLACK: f64 = 1e-3;

/// Returns the center and the radius of a bounding sphere, and half the edges of a bounding box about the same center, if that has the
/// smaller cross section, on average over all directions.
fn volumes(object: &Object) -> (DVec3, f64, Option<DMat3>) {
    let (lo, hi) = object.shape.bounds(DAffine3::IDENTITY);
    let map = object.transform.0;
    let half = DMat3::from_cols_array_2d(&[0, 1, 2].map(|i| (0.5 * (hi - lo)[i] * map.matrix3.col(i)).to_array()));
    let longest = [0, 1, 2].map(|i| half.col(i).length()).into_iter().fold(0.0, f64::max);
    let edge = |i| map.matrix3.col(i).normalize() * (half.col(i).length().max(SLACK * longest) + SLACK * longest);
    let edges = DMat3::from_cols(edge(0), edge(1), edge(2));
    let corners = [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]].map(|[y, z]| edges * DVec3::new(1.0, y, z));
    let radius = corners.map(DVec3::length).into_iter().fold(0.0, f64::max);
    let (middle, ball) = object.ball();
    let face = |i, k| edges.col(i).cross(edges.col(k)).length();
    // The mean cross section of a convex body is a quarter of its surface (Cauchy).
    let section = 2.0 * (face(0, 1) + face(1, 2) + face(2, 0));
    let is_tighter = section < std::f64::consts::PI * ball * ball && edges.determinant() != 0.0;
    if is_tighter && section.is_finite() {
        (map.transform_point3(0.5 * (lo + hi)), radius, Some(edges))
    } else {
        (middle, ball, None)
    }
}
