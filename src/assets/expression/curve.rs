//! Curves: three functions of t as the user writes them, with their derivatives.

use glam::DVec3;

use super::tree::Tree;
use super::{Enclosure, FormulaError, Graph, Id, Interval, PARAMETER, Variable, check, parse_all};

/// Derivatives that a curve knows: the fourth bounds how far it is from a cubic.
const ORDERS: usize = 5;

/// x(t), y(t) and z(t), and their derivatives.
#[derive(Debug, Clone)]
pub struct Curve {
    trees: [Tree; 3],
    graph: Graph,
    /// By the order of the derivative, from 0.
    derivatives: [[Id; 3]; ORDERS],
}

impl Curve {
    /// From the text of each coordinate.
    ///
    /// # Errors
    ///
    /// What is wrong with which coordinates.
    pub fn parse(texts: [&str; 3]) -> Result<Self, Vec<(usize, FormulaError)>> {
        let trees = parse_all(texts, &PARAMETER)?;
        let mut graph = Graph::default();
        let mut derivatives = [[0, 1, 2].map(|k: usize| graph.of_tree(&trees[k])); ORDERS];
        for order in 1..ORDERS {
            derivatives[order] = derivatives[order - 1].map(|id| graph.derivative(id, Variable::PARAMETER));
        }
        // What runs on the device: the place, the velocity and the acceleration.
        let wrong = |k: usize| {
            let roots = [0, 1, 2].map(|order: usize| derivatives[order][k]);
            Some((k, check(texts[k], &graph, &roots).err()?))
        };
        let wrong: Vec<_> = (0..3).filter_map(wrong).collect();
        if wrong.is_empty() { Ok(Self { trees, graph, derivatives }) } else { Err(wrong) }
    }

    /// Place, velocity, acceleration and two more derivatives at t; not finite where there are none.
    #[must_use]
    pub fn at(&self, t: f64) -> [DVec3; ORDERS] {
        let values = self.graph.evaluate(&[t]);
        self.derivatives.map(|ids| DVec3::from_array(ids.map(|id| values[id.index()])))
    }

    /// The same over all t of an interval, and whether the curve has no kink there.
    #[must_use]
    pub fn over(&self, t: Interval) -> ([[Interval; 3]; ORDERS], bool) {
        let all: Enclosure = self.graph.enclose(&[t]);
        (self.derivatives.map(|ids| ids.map(|id| all.of(id))), all.smooth)
    }

    /// The graph, and in it the derivatives of this order.
    #[must_use]
    pub fn graph(&self, order: usize) -> (&Graph, [Id; 3]) {
        (&self.graph, self.derivatives[order])
    }

    /// The coordinates, as they would be written.
    #[must_use]
    pub fn texts(&self) -> [String; 3] {
        [0, 1, 2].map(|k: usize| self.trees[k].to_string())
    }
}

/// The same formulas, not only the same curve.
impl PartialEq for Curve {
    fn eq(&self, other: &Self) -> bool {
        self.trees == other.trees
    }
}
