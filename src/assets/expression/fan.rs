//! Fans: directions and weights as the user writes them, of a surface's normal and a ray that comes in.

use glam::{DVec3, DVec4};

use super::tree::Tree;
use super::{FAN, FormulaError, Graph, Id, check, parse};

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
        let parsed = texts.map(|text| parse::parse(text, &FAN));
        let [Ok(x), Ok(y), Ok(z), Ok(w)] = &parsed else {
            let wrong = parsed.into_iter().enumerate();
            return Err(wrong.filter_map(|(k, parsed)| Some((k, parsed.err()?))).collect());
        };
        let trees = [x.clone(), y.clone(), z.clone(), w.clone()];
        let mut graph = Graph::default();
        let roots = [0, 1, 2, 3].map(|k: usize| graph.of_tree(&trees[k]));
        let wrong = |k: usize| Some((k, check(texts[k], &graph, &roots[k..=k]).err()?));
        let wrong: Vec<_> = (0..4).filter_map(wrong).collect();
        if wrong.is_empty() { Ok(Self { trees, graph, roots }) } else { Err(wrong) }
    }

    /// Direction and weight, of unit vectors: that of the ray that comes in, and the normal on its side.
    #[must_use]
    pub fn at(&self, d: DVec3, n: DVec3) -> DVec4 {
        let values = self.graph.evaluate(&[d.x, d.y, d.z, n.x, n.y, n.z, -d.dot(n)]);
        DVec4::from_array(self.roots.map(|id| values[id.index()]))
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
