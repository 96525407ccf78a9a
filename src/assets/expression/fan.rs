//! Fans: directions and weights as the user writes them, of a surface's normal and a ray that comes in.

use super::tree::Tree;
use super::{FAN, FormulaError, Graph, Id, check, parse_all};

/// A direction and a weight, as functions of the ray that comes in and of the normal.
#[derive(Debug, Clone)]
pub struct FanRay {
    trees: [Tree; 4],
    graph: Graph,
    roots: [Id; 4],
}

impl FanRay {
    /// From the text of each coordinate and of the weight.
    ///
    /// # Errors
    ///
    /// What is wrong with which of them.
    pub fn parse(texts: [&str; 4]) -> Result<Self, Vec<(usize, FormulaError)>> {
        let trees = parse_all(texts, &FAN)?;
        let mut graph = Graph::default();
        let roots = [0, 1, 2, 3].map(|k: usize| graph.of_tree(&trees[k]));
        let wrong = |k: usize| Some((k, check(texts[k], &graph, &roots[k..=k]).err()?));
        let wrong: Vec<_> = (0..4).filter_map(wrong).collect();
        if wrong.is_empty() { Ok(Self { trees, graph, roots }) } else { Err(wrong) }
    }

    /// The graph, and in it the direction and the weight.
    #[must_use]
    pub fn graph(&self) -> (&Graph, [Id; 4]) {
        (&self.graph, self.roots)
    }
}

/// The same formulas.
impl PartialEq for FanRay {
    fn eq(&self, other: &Self) -> bool {
        self.trees == other.trees
    }
}
