//! Builds the tree of boxes over a curve that all rays follow (G95 §3.2), and the hierarchy of objects that it is intersected with.
//!
//! *Theory.* The box of a node contains its whole piece of the curve. If the derivative of a coordinate keeps its sign, the extrema are at
//! the ends. Otherwise the box comes from interval arithmetic: the smaller of the formula itself and its mean value form c(m) + c′([t])([t]
//! − m). A piece is bisected in t until it can be treated as a cubic: until the fourth derivative keeps the Hermite cubic through its ends
//! within the tolerance of the arc (h⁴/384 max|c⁗|), and the second derivative allows few chords.
//!
//! *Practice.* G95 cuts boxes in the middle of an axis along which the curve rises. Here t is cut instead, because a curve need not rise
//! along any axis. The whole tree is built before the first ray and serves all rays, because the start of a ray only translates its curve.

use glam::{DVec3, Vec3};

use super::hierarchy::{Item, Node, hierarchy};
use crate::assets::Interval;
use crate::model::law::Parametric;
use crate::program::constant;

/// A piece of the curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RayNode {
    /// The corners of the box of the untranslated curve.
    pub corners: [DVec3; 2],
    /// The values of τ at its beginning and end.
    pub tau: [f64; 2],
    /// The node that follows this node's subtree.
    pub skip: u32,
    /// `true` if it is not cut further.
    pub leaf: bool,
}

/// Returns the tree in depth-first order, for arcs with this `tolerance`.
#[must_use]
pub fn ray_tree(curve: &Parametric, length: f64, tolerance: f64) -> Vec<RayNode> {
    let pieces = constant("segment/curve_arc", "MAX_PIECES");
    // Curves whose derivatives have a kink or a pole are cut down to this depth there, and no further.
    let deepest = constant("motion/parametric", "DEPTH") as u32;
    let mut nodes = Vec::new();
    // `Err` closes the node whose subtree ended.
    let mut open = vec![Ok(([0.0, length], 0))];
    while let Some(next) = open.pop() {
        let ([a, b], depth) = match next {
            Ok(piece) => piece,
            Err(node) => {
                let skip: usize = nodes.len();
                let node: &mut RayNode = &mut nodes[node];
                node.skip = skip as u32;
                continue;
            }
        };
        let piece = Piece::new(curve, a, b);
        let leaf = depth >= deepest || piece.is_cubic(tolerance, pieces);
        open.push(Err(nodes.len()));
        let middle = 0.5 * (a + b);
        if !leaf {
            open.extend([Ok(([middle, b], depth + 1)), Ok(([a, middle], depth + 1))]);
        }
        nodes.push(RayNode { corners: piece.corners(), tau: [a, b], skip: 0, leaf });
    }
    nodes
}

/// The curve from a to b.
struct Piece {
    ends: [[DVec3; 5]; 2],
    middle: [DVec3; 5],
    all: [[Interval; 3]; 5],
    smooth: bool,
    size: f64,
}

impl Piece {
    fn new(curve: &Parametric, a: f64, b: f64) -> Self {
        let (all, smooth) = curve.over(Interval::between(a, b));
        let middle = curve.at(0.5 * (a + b));
        Self { ends: [curve.at(a), curve.at(b)], middle, all, smooth, size: b - a }
    }

    fn corners(&self) -> [DVec3; 2] {
        let axes: [Interval; 3] = [0, 1, 2].map(|k| self.coordinate(k));
        // Allow for the rounding error of the ends.
        let wide = |value: f64, sign: f64| value + sign * 1e-12 * (1.0 + value.abs());
        [DVec3::from_array(axes.map(|own| wide(own.lo, -1.0))), DVec3::from_array(axes.map(|own| wide(own.hi, 1.0)))]
    }

    fn coordinate(&self, k: usize) -> Interval {
        let (value, slope) = (self.all[0][k], self.all[1][k]);
        let ends = Interval::between(self.ends[0][0][k], self.ends[1][0][k]);
        if self.smooth && (slope.lo >= 0.0 || slope.hi <= 0.0) {
            return ends;
        }
        let half = Interval { lo: -0.5 * self.size, hi: 0.5 * self.size };
        let mean = Interval::at(self.middle[0][k]).plus(slope.times(half));
        // Both contain the ends, which rounding must not lose.
        let both = if mean.is_finite() && self.smooth { value.and(mean) } else { value };
        both.or(ends)
    }

    /// Returns `true` if the Hermite cubic through the ends is within `tolerance` and straight enough for `pieces` chords.
    fn is_cubic(&self, tolerance: f64, pieces: f64) -> bool {
        let most = |order: usize| DVec3::from_array(self.all[order].map(Interval::magnitude)).length();
        let cubic = most(4) * self.size.powi(4) / 384.0 <= 0.5 * tolerance;
        let chords = most(2) * self.size.powi(2) / 8.0 <= tolerance * pieces * pieces;
        self.smooth && cubic && chords
    }
}

/// The number of boxes above which parts of the scene's acceleration structure replace them.
const MANY: usize = 1 << 16;

/// Builds a hierarchy over the boxes of objects, whose leaves are single boxes.
#[must_use]
pub fn object_tree(boxes: impl Iterator<Item = (Vec3, Vec3)>) -> Vec<Node> {
    let items: Vec<Item> = boxes.map(|(lo, hi)| Item { primitive: 0, lo, hi }).collect();
    if items.is_empty() {
        // No list in a shader may be empty, so add a box that nothing meets.
        return vec![Node { lo: Vec3::splat(f32::MAX), hi: Vec3::splat(-f32::MAX), skip: 1, leaf: 1 }];
    }
    hierarchy(&items, 1).0
}

/// Returns boxes that together contain all items; if there are many, these are the boxes of parts of the hierarchy over them.
#[must_use]
pub fn coarse(items: &[Item], nodes: &[Node]) -> Vec<(Vec3, Vec3)> {
    if items.len() <= MANY || nodes.is_empty() {
        return items.iter().map(|item| (item.lo, item.hi)).collect();
    }
    let most = 4 * items.len() / MANY;
    let (mut found, mut at) = (Vec::new(), 0);
    while at < nodes.len() {
        let node = &nodes[at];
        let is_part = node.leaf != 0 || node.skip as usize - at <= most;
        if is_part {
            found.push((node.lo, node.hi));
        }
        at = if is_part { node.skip as usize } else { at + 1 };
    }
    found
}

#[cfg(test)]
mod tests {
    use glam::DMat3;
    use proptest::prelude::*;

    use super::*;
    use crate::assets::Curve;

    fn parametric(texts: [&str; 3], first: f64, last: f64, turned: Option<DMat3>) -> Parametric {
        Parametric { curve: Curve::parse(texts).unwrap(), first, last, turned }
    }

    const CURVES: [[&str; 3]; 7] = [
        ["t^2", "t", "2"],
        ["cos(2*t)", "t", "sin(2*t)"],
        ["t*cos(t)", "0.3*t^3 - t", "exp(-t)*sin(5*t)"],
        ["abs(t - 1.3)", "max(t, 2)", "min(sin(3*t), 0.4)"],
        ["sqrt(t + 0.01)", "tanh(t)", "atan(4*t - 3)"],
        ["1/(1 + t^2)", "log(t + 2)", "cosh(0.4*t)"],
        ["tan(0.3*t)", "sinh(0.5*t)", "t^-2 * t^3"],
    ];

    proptest! {
        /// Checks that the box of every node contains its piece, and that the error of every leaf's cubic is within the tolerance.
        #[test]
        fn boxes_hold_their_pieces(which in 0..CURVES.len(), first in 0.05_f64..1.0, length in 0.3_f64..3.5,
            angle in 0.0_f64..6.0, turns in any::<bool>(), fraction in 0.0_f64..1.0) {
            let turned = turns.then(|| DMat3::from_axis_angle(DVec3::new(1.0, 2.0, 2.0) / 3.0, angle));
            let curve = parametric(CURVES[which], first, first + length, turned);
            let tolerance = 1e-5;
            let nodes = ray_tree(&curve, length, tolerance);
            prop_assert_eq!(nodes[0].skip as usize, nodes.len());
            for (i, node) in nodes.iter().enumerate() {
                let [a, b] = node.tau;
                let x = curve.at(a + fraction * (b - a))[0];
                let [lo, hi] = node.corners;
                prop_assert!(x.cmpge(lo).all() && x.cmple(hi).all(), "{:?} at {}: {} is not in {} to {}", CURVES[which], a, x, lo, hi);
                prop_assert!(node.leaf == (node.skip as usize == i + 1));
                if node.leaf && b - a > length * 0.5_f64.powi(14) * 1.5 {
                    let ([p, v, ..], [q, w, ..], h) = (curve.at(a), curve.at(b), b - a);
                    let (t, u, c) = (fraction, 1.0 - fraction, q - p);
                    let cubic = p + t * (c + u * (u * (h * v - c) + t * (c - h * w)));
                    prop_assert!((cubic - x).length() <= tolerance, "{:?}: {} from {a} to {b}, {:?} {:?}", CURVES[which], (cubic - x).length(), x, cubic);
                }
            }
            let ends: Vec<f64> = nodes.iter().filter(|node| node.leaf).map(|node| node.tau[1]).collect();
            prop_assert!(ends.windows(2).all(|pair| pair[0] < pair[1]) && ends.last() == Some(&length));
        }
    }

    #[test]
    fn parts_hold_everything() {
        let items: Vec<Item> = (0..MANY as u32 + 5000)
            .map(|i| {
                let lo = Vec3::new((i % 97) as f32, (i % 89) as f32, (i % 83) as f32);
                Item { primitive: i, lo, hi: lo + 0.5 }
            })
            .collect();
        let (nodes, _) = hierarchy(&items, 4);
        let parts = coarse(&items, &nodes);
        assert!(parts.len() < items.len());
        for item in items.iter().step_by(997) {
            assert!(parts.iter().any(|(lo, hi)| lo.cmple(item.lo).all() && hi.cmpge(item.hi).all()));
        }
    }
}
