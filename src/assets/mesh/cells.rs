//! Vertices grouped by position, to find the maximum of a function without evaluating it at all of them.
//!
//! *Practice.* Scenes may have thousands of instances of one mesh, and need a bounding box of each. A convex function on a box is largest
//! at one of the corners: cells whose corners stay below the maximum found so far are skipped.

use glam::{DVec3, Vec3};

use super::Vertex;

/// The number of cells along each axis.
const CELLS: f32 = 12.0;

/// Vertices grouped by the cells of a grid.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Cells {
    /// The indices of the vertices, cell by cell.
    order: Vec<u32>,
    /// The cells with vertices: the bounding box of the vertices, and their end in the order.
    filled: Vec<(Vec3, Vec3, u32)>,
}

impl Cells {
    pub(super) fn of(vertices: &[Vertex]) -> Self {
        let nothing = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        let grown = |(lo, hi): (Vec3, Vec3), x: Vec3| (lo.min(x), hi.max(x));
        let (lo, hi) = vertices.iter().map(|vertex| vertex.position).fold(nothing, grown);
        let scale = CELLS / (hi - lo).max(Vec3::splat(f32::MIN_POSITIVE));
        let cell = |i: &u32| {
            let at = ((vertices[*i as usize].position - lo) * scale).min(Vec3::splat(CELLS - 1.0)).as_u8vec3();
            at.to_array()
        };
        let mut order: Vec<u32> = (0..vertices.len() as u32).collect();
        order.sort_by_cached_key(cell);
        let mut filled = Vec::new();
        let mut end = 0;
        for own in order.chunk_by(|a, b| cell(a) == cell(b)) {
            let (lo, hi) = own.iter().map(|i| vertices[*i as usize].position).fold(nothing, grown);
            end += own.len() as u32;
            filled.push((lo, hi, end));
        }
        Self { order, filled }
    }

    /// Returns the largest value of a convex function at a vertex; −∞ without vertices.
    pub(super) fn most(&self, vertices: &[Vertex], value: impl Fn(DVec3) -> f64) -> f64 {
        let corner = |lo: Vec3, hi: Vec3, k: u32| {
            let side = |axis: u32| k >> axis & 1 == 1;
            Vec3::select(glam::BVec3::new(side(0), side(1), side(2)), hi, lo).as_dvec3()
        };
        let above = |&(lo, hi, _): &(Vec3, Vec3, u32)| {
            (0..8).map(|k| value(corner(lo, hi, k))).fold(f64::NEG_INFINITY, f64::max)
        };
        let mut open: Vec<(f64, usize)> = self.filled.iter().map(above).zip(0..).collect();
        open.sort_unstable_by(|a, b| b.0.total_cmp(&a.0));
        let mut most = f64::NEG_INFINITY;
        for (bound, i) in open {
            if bound <= most {
                break;
            }
            let first = i.checked_sub(1).map_or(0, |before| self.filled[before].2);
            let own = &self.order[first as usize..self.filled[i].2 as usize];
            most = own.iter().map(|i| value(vertices[*i as usize].position.as_dvec3())).fold(most, f64::max);
        }
        most
    }
}

#[cfg(test)]
mod tests {
    use glam::{DMat3, Vec2};
    use proptest::prelude::*;

    use super::*;

    fn number() -> impl Strategy<Value = f32> {
        prop_oneof![-1.0_f32..1.0, Just(0.5), -1e30_f32..1e30]
    }

    proptest! {
        #[allow(clippy::float_cmp, reason = "the same values are compared")]
        /// The result is bit-identical to the maximum over all vertices.
        #[test]
        fn the_most_of_all_is_found(places in prop::collection::vec([number(), number(), number()], 0..300), m in prop::array::uniform9(-2.0..2.0), c in prop::array::uniform3(-3.0..3.0)) {
            let vertex = |p: &[f32; 3]| Vertex { position: Vec3::from_array(*p), normal: Vec3::Y, uv: Vec2::ZERO };
            let vertices: Vec<Vertex> = places.iter().map(vertex).collect();
            let cells = Cells::of(&vertices);
            let (m, c) = (DMat3::from_cols_array(&m), DVec3::from_array(c));
            let far = |p: DVec3| (m * p).distance(c);
            let along = |p: DVec3| (m * p - c).x;
            for value in [&far as &dyn Fn(DVec3) -> f64, &along] {
                let all = vertices.iter().map(|vertex| value(vertex.position.as_dvec3())).fold(f64::NEG_INFINITY, f64::max);
                prop_assert_eq!(cells.most(&vertices, value), all);
            }
        }
    }
}
