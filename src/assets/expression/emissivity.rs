//! Emissivities: the light that a surface sends out, as the user writes it, as a function of place, time and direction.

use std::str::FromStr;

use super::parse::parse;
use super::{EMISSION, FormulaError, Graph, Id, check};

/// The light that a surface emits, as a function of r, phi, t and mu.
#[derive(Debug, Clone)]
pub struct Emissivity {
    graph: Graph,
    value: Id,
}

impl FromStr for Emissivity {
    type Err = FormulaError;

    fn from_str(text: &str) -> Result<Self, FormulaError> {
        let mut graph = Graph::default();
        let value = graph.of_tree(&parse(text, &EMISSION)?);
        check(text, &graph, &[value])?;
        Ok(Self { graph, value })
    }
}

impl Emissivity {
    /// Returns the value at a radius, an azimuth, a time, and the cosine of the angle between the light and the surface normal; not finite
    /// where it does not exist.
    #[must_use]
    pub fn at(&self, r: f64, phi: f64, t: f64, mu: f64) -> f64 {
        self.graph.evaluate(&[r, phi, t, mu])[self.value.index()]
    }
}
