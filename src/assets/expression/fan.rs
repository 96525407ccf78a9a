//! Fans: directions and weights as the user writes them, as functions of a surface normal and an incoming ray.

use super::tree::Tree;
use super::{FAN, FormulaError, Graph, Id, check, parse_all};

/// A direction and a weight, as functions of the incoming ray and the normal.
#[derive(Debug, Clone)]
pub struct FanRay {
    trees: [Tree; 4],
    graph: Graph,
    roots: [Id; 4],
}

impl FanRay {
    /// Parses the texts of the three coordinates and the weight.
    ///
    /// # Errors
    ///
    /// The errors, each with the index of its text.
    pub fn parse(texts: [&str; 4]) -> Result<Self, Vec<(usize, FormulaError)>> {
        let trees = parse_all(texts, &FAN)?;
        let mut graph = Graph::default();
        let roots = [0, 1, 2, 3].map(|k: usize| graph.of_tree(&trees[k]));
        let wrong = |k: usize| Some((k, check(texts[k], &graph, &roots[k..=k]).err()?));
        let wrong: Vec<_> = (0..4).filter_map(wrong).collect();
        if wrong.is_empty() { Ok(Self { trees, graph, roots }) } else { Err(wrong) }
    }

    /// Returns the graph, and its nodes of the direction and the weight.
    #[must_use]
    pub fn graph(&self) -> (&Graph, [Id; 4]) {
        (&self.graph, self.roots)
    }
}

/// Fan rays are equal if their formulas are.
impl PartialEq for FanRay {
    fn eq(&self, other: &Self) -> bool {
        self.trees == other.trees
    }
}
