//! Formulas: functions of position as the user writes them, `1 + 0.1 * exp(-r^2)`, with their exact gradients; and curves, whose
//! coordinates are functions of t.
//!
//! *Theory.* A formula has variables, numbers, pi, + − * / ^, parentheses and a few functions. Its text becomes
//! a tree (`tokens`, `parse`, `tree`), and the tree a graph in which equal subexpressions are one node (`graph`): derivatives,
//! which repeat the function's subexpressions many times, thus stay about as small as the formula (`derive`, `rules`).
//!
//! *Practice.* A formula is valid once it is made: every number in it is a 32-bit float, and no subexpression is a constant without
//! a value. It may still have no value at some positions, such as log(x) at x = 0; its callers handle that.

mod curve;
mod derive;
mod emissivity;
mod fan;
mod functions;
mod graph;
mod interval;
mod line_element;
mod parse;
mod rules;
mod spacetime;
#[cfg(test)]
mod tests;
mod tokens;
mod tree;
mod variable;
mod volume;
mod volume_texts;

pub use curve::Curve;
pub use emissivity::Emissivity;
pub use fan::FanRay;
pub use functions::Function;
pub use graph::{Graph, Id, Node};
pub use interval::{Enclosure, Interval};
pub use line_element::{LineElement, Spot};
pub use spacetime::{Field, Spacetime};
pub use variable::Variable;
pub use volume::{Coefficients, MOST_GRIDS, VolumeFormulas};
pub use volume_texts::{VolumeField, VolumeTexts};

use glam::DVec3;
use std::fmt;
use std::ops::Range;
use tree::{Name, Tree};

/// The names in formulas of one sort, except functions.
#[derive(Debug)]
struct Language {
    names: &'static [Name],
    /// An example of a formula with these names.
    example: &'static str,
    /// The names that users define for formulas.
    terms: Vec<String>,
}

impl Language {
    /// Returns all names except function names.
    fn known(&self) -> impl Iterator<Item = &str> {
        self.names.iter().map(|name| name.text()).chain(self.terms.iter().map(String::as_str))
    }

    /// Returns the tree of a name, if it is known.
    fn named(&self, text: &str) -> Option<Tree> {
        let name = self.names.iter().find(|name| name.text() == text).map(|name| Tree::Name(*name));
        name.or_else(|| Some(Tree::Term(text.to_owned(), self.terms.iter().position(|term| term == text)?)))
    }
}

/// Functions of position.
static PLACE: Language = Language {
    names: &[
        Name::Variable("x", Variable::PLACE[0]),
        Name::Variable("y", Variable::PLACE[1]),
        Name::Variable("z", Variable::PLACE[2]),
        Name::R,
        Name::Pi,
    ],
    example: "1 + 0.1 * exp(-r^2)",
    terms: Vec::new(),
};

/// Functions of a curve's parameter.
static PARAMETER: Language =
    Language { names: &[Name::Variable("t", Variable::PARAMETER), Name::Pi], example: "cos(2 * t)", terms: Vec::new() };

/// Functions of a ray that arrives at a surface, and of the normal on its side; c is the cosine between both.
static FAN: Language = Language {
    names: &[
        Name::Variable("dx", Variable(0)),
        Name::Variable("dy", Variable(1)),
        Name::Variable("dz", Variable(2)),
        Name::Variable("nx", Variable(3)),
        Name::Variable("ny", Variable(4)),
        Name::Variable("nz", Variable(5)),
        Name::Variable("c", Variable(6)),
        Name::Pi,
    ],
    example: "dx + 2*c*nx",
    terms: Vec::new(),
};

/// Functions of where, when and at which angle light leaves a surface; mu is the cosine of the angle to the normal.
static EMISSION: Language = Language {
    names: &[
        Name::Variable("r", Variable(0)),
        Name::Variable("phi", Variable(1)),
        Name::Variable("t", Variable(2)),
        Name::Variable("mu", Variable(3)),
        Name::Pi,
    ],
    example: "r^-3",
    terms: Vec::new(),
};

/// A function of position and its gradient.
#[derive(Debug, Clone)]
pub struct Formula {
    tree: Tree,
    graph: Graph,
    value: Id,
    gradient: [Id; 3],
}

/// An error in the text of a formula.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FormulaError {
    /// The location, in bytes of the text.
    pub place: Range<usize>,
    /// The problem.
    pub problem: String,
    /// The remedy; may be empty.
    pub help: String,
}

impl Formula {
    /// Parses a formula and derives its gradient.
    ///
    /// # Errors
    ///
    /// Returns the first error of the text with its location: a syntax error, an unknown name, a formula that is too long or too deep, or a
    /// constant that 32 bits cannot hold.
    pub fn parse(text: &str) -> Result<Self, FormulaError> {
        let tree = parse::parse(text, &PLACE)?;
        let mut graph = Graph::default();
        let value = graph.of_tree(&tree);
        let gradient = Variable::PLACE.map(|axis| graph.derivative(value, axis));
        let [x, y, z] = gradient;
        check(text, &graph, &[x, y, z, value])?;
        Ok(Self { tree, graph, value, gradient })
    }

    /// Returns the value at a position; not finite where it does not exist.
    #[must_use]
    pub fn value(&self, place: DVec3) -> f64 {
        self.graph.evaluate(&place.to_array())[self.value.index()]
    }

    /// Returns the gradient at a position.
    #[must_use]
    pub fn gradient(&self, place: DVec3) -> DVec3 {
        let values = self.graph.evaluate(&place.to_array());
        DVec3::from_array(self.gradient.map(|id| values[id.index()]))
    }

    /// Returns the value if it is constant.
    #[must_use]
    pub fn constant(&self) -> Option<f64> {
        self.graph.number(self.value)
    }

    /// Returns the graph, and its nodes of the three components of the gradient and of the value.
    #[must_use]
    pub fn graph(&self) -> (&Graph, [Id; 4]) {
        let [x, y, z] = self.gradient;
        (&self.graph, [x, y, z, self.value])
    }
}

/// Parses several formulas that belong together; each error has the index of its text.
fn parse_all<const N: usize>(texts: [&str; N], language: &Language) -> Result<[Tree; N], Vec<(usize, FormulaError)>> {
    let mut wrong = Vec::new();
    let trees = texts.map(|text| parse::parse(text, language)).into_iter().enumerate();
    let trees: Vec<Tree> = trees.filter_map(|(k, tree)| tree.map_err(|error| wrong.push((k, error))).ok()).collect();
    trees.try_into().map_err(|_| wrong)
}

/// Checks that 32 bits can hold the numbers, and that all constants have a value.
fn check(text: &str, graph: &Graph, roots: &[Id]) -> Result<(), FormulaError> {
    let wrong = |problem: String| FormulaError {
        place: 0..text.len(),
        problem,
        help: "all numbers, including computed constants, must be 0 or have a magnitude from 1e-37 to 1e38".to_owned(),
    };
    for id in graph.reached(roots) {
        if let Some(number) = graph.number(id) {
            if number != 0.0 && !(1e-37..=1e38).contains(&number.abs()) {
                let problem = format!("the computed constant {number:e} is outside the range of 32-bit floats");
                return Err(wrong(problem));
            }
        } else {
            let parts = graph.parts(id);
            if !parts.is_empty() && parts.iter().all(|part| graph.number(*part).is_some()) {
                return Err(wrong("a constant part of the formula has no finite value".to_owned()));
            }
        }
    }
    Ok(())
}

/// Writes the formula in normalized spelling, without unnecessary parentheses.
impl fmt::Display for Formula {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        self.tree.fmt(f)
    }
}

/// Formulas are equal if their texts are equivalent, not only their values.
impl PartialEq for Formula {
    fn eq(&self, other: &Self) -> bool {
        self.tree == other.tree
    }
}
