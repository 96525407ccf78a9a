//! Curves: three functions of t as the user writes them, with their derivatives.

use glam::DVec3;

use super::tree::Tree;
use super::{Enclosure, FormulaError, Graph, Id, Interval, PARAMETER, Variable, check, parse_all};

/// The number of derivatives of a curve, including the 0th; the fourth bounds the deviation from a cubic.
const ORDERS: usize = 5;

/// The functions x(t), y(t) and z(t), with their derivatives.
#[derive(Debug, Clone)]
pub struct Curve {
    trees: [Tree; 3],
    graph: Graph,
    /// The derivatives by order, from 0.
    derivatives: [[Id; 3]; ORDERS],
}

impl Curve {
    /// Parses the texts of the three coordinates.
    ///
    /// # Errors
    ///
    /// The errors, each with the index of its coordinate.
    pub fn parse(texts: [&str; 3]) -> Result<Self, Vec<(usize, FormulaError)>> {
        let trees = parse_all(texts, &PARAMETER)?;
        let mut graph = Graph::default();
        let mut derivatives = [[0, 1, 2].map(|k: usize| graph.of_tree(&trees[k])); ORDERS];
        for order in 1..ORDERS {
            derivatives[order] = derivatives[order - 1].map(|id| graph.derivative(id, Variable::PARAMETER));
        }
        // The device computes the position, the velocity and the acceleration.
        let wrong = |k: usize| {
            let roots = [0, 1, 2].map(|order: usize| derivatives[order][k]);
            Some((k, check(texts[k], &graph, &roots).err()?))
        };
        let wrong: Vec<_> = (0..3).filter_map(wrong).collect();
        if wrong.is_empty() { Ok(Self { trees, graph, derivatives }) } else { Err(wrong) }
    }

    /// Returns position, velocity, acceleration and two more derivatives at t; not finite where they do not exist.
    #[must_use]
    pub fn at(&self, t: f64) -> [DVec3; ORDERS] {
        let values = self.graph.evaluate(&[t]);
        self.derivatives.map(|ids| DVec3::from_array(ids.map(|id| values[id.index()])))
    }

    /// Returns the range of each derivative over an interval of t, and whether the curve has no kink there.
    #[must_use]
    pub fn over(&self, t: Interval) -> ([[Interval; 3]; ORDERS], bool) {
        let all: Enclosure = self.graph.enclose(&[t]);
        (self.derivatives.map(|ids| ids.map(|id| all.of(id))), all.smooth)
    }

    /// Returns the graph, and its nodes of the derivatives of this order.
    #[must_use]
    pub fn graph(&self, order: usize) -> (&Graph, [Id; 3]) {
        (&self.graph, self.derivatives[order])
    }

    /// Returns the coordinates in normalized spelling.
    #[must_use]
    pub fn texts(&self) -> [String; 3] {
        [0, 1, 2].map(|k: usize| self.trees[k].to_string())
    }
}

/// Curves are equal if their formulas are, not only their values.
impl PartialEq for Curve {
    fn eq(&self, other: &Self) -> bool {
        self.trees == other.trees
    }
}
