//! Formulas: a function of place as the user writes it, `1 + 0.1 * exp(-r^2)`, with its exact gradient; and curves, whose coordinates
//! are functions of t.
//!
//! *Theory.* A formula has variables, numbers, pi, + − * / ^, parentheses and a few functions. Its text becomes
//! a tree (`tokens`, `parse`, `tree`), and the tree a graph in which equal parts are one node (`graph`): there derivatives,
//! which repeat the function's own parts over and over, stay about as small as the formula (`derive`, `rules`).
//!
//! *Practice.* A formula is valid once it is made: every number in it is one of 32-bit floats, no part of it is a constant without
//! a value. It may still have no value at some places, such as log(x) at x = 0: that is for who evaluates it.

mod curve;
mod derive;
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

pub use curve::Curve;
pub use fan::FanRay;
pub use functions::Function;
pub use graph::{Graph, Id, Node};
pub use interval::{Enclosure, Interval};
pub use line_element::{LineElement, Spot};
pub use spacetime::{Field, Spacetime};
pub use variable::Variable;

use glam::DVec3;
use std::fmt;
use std::ops::Range;
use tree::{Name, Tree};

/// The names that formulas of one sort have, besides functions.
#[derive(Debug)]
struct Language {
    names: &'static [Name],
    /// A formula in them.
    example: &'static str,
    /// Names that stand for formulas.
    terms: Vec<String>,
}

impl Language {
    /// All names but those of functions.
    fn known(&self) -> impl Iterator<Item = &str> {
        self.names.iter().map(|name| name.text()).chain(self.terms.iter().map(String::as_str))
    }

    /// What a name stands for.
    fn named(&self, text: &str) -> Option<Tree> {
        let name = self.names.iter().find(|name| name.text() == text).map(|name| Tree::Name(*name));
        name.or_else(|| Some(Tree::Term(text.to_owned(), self.terms.iter().position(|term| term == text)?)))
    }
}

/// Functions of place.
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

/// Functions of a ray that comes to a surface, and of the normal on its side; c is the cosine between both.
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

/// A function of place and its gradient.
#[derive(Debug, Clone)]
pub struct Formula {
    tree: Tree,
    graph: Graph,
    value: Id,
    gradient: [Id; 3],
}

/// What is wrong with the text of a formula.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FormulaError {
    /// Where, in bytes of the text.
    pub place: Range<usize>,
    /// What is wrong.
    pub problem: String,
    /// What would be right; may be empty.
    pub help: String,
}

impl Formula {
    /// Reads a formula and derives its gradient.
    pub fn parse(text: &str) -> Result<Self, FormulaError> {
        let tree = parse::parse(text, &PLACE)?;
        let mut graph = Graph::default();
        let value = graph.of_tree(&tree);
        let gradient = Variable::PLACE.map(|axis| graph.derivative(value, axis));
        let [x, y, z] = gradient;
        check(text, &graph, &[x, y, z, value])?;
        Ok(Self { tree, graph, value, gradient })
    }

    /// Its value at a place; not finite where it has none.
    #[must_use]
    pub fn value(&self, place: DVec3) -> f64 {
        self.graph.evaluate(&place.to_array())[self.value.index()]
    }

    /// Its gradient at a place.
    #[must_use]
    pub fn gradient(&self, place: DVec3) -> DVec3 {
        let values = self.graph.evaluate(&place.to_array());
        DVec3::from_array(self.gradient.map(|id| values[id.index()]))
    }

    /// Its value if it is the same everywhere.
    #[must_use]
    pub fn constant(&self) -> Option<f64> {
        self.graph.number(self.value)
    }

    /// The graph, and in it the three parts of the gradient and the value.
    #[must_use]
    pub fn graph(&self) -> (&Graph, [Id; 4]) {
        let [x, y, z] = self.gradient;
        (&self.graph, [x, y, z, self.value])
    }
}

/// Several formulas of one thing: their trees, or what is wrong with which of them.
fn parse_all<const N: usize>(texts: [&str; N], language: &Language) -> Result<[Tree; N], Vec<(usize, FormulaError)>> {
    let mut wrong = Vec::new();
    let trees = texts.map(|text| parse::parse(text, language)).into_iter().enumerate();
    let trees: Vec<Tree> = trees.filter_map(|(k, tree)| tree.map_err(|error| wrong.push((k, error))).ok()).collect();
    trees.try_into().map_err(|_| wrong)
}

/// Numbers that 32 bits hold, and no constant that could not be worked out.
fn check(text: &str, graph: &Graph, roots: &[Id]) -> Result<(), FormulaError> {
    let wrong = |problem: String| FormulaError {
        place: 0..text.len(),
        problem,
        help: "all numbers, also those that follow from others, are 0 or from 1e-37 to 1e38 in magnitude".to_owned(),
    };
    for id in graph.reached(roots) {
        if let Some(number) = graph.number(id) {
            if number != 0.0 && !(1e-37..=1e38).contains(&number.abs()) {
                let problem =
                    format!("the number {number:e}, which follows from it, is beyond the range of 32-bit floats");
                return Err(wrong(problem));
            }
        } else {
            let parts = graph.parts(id);
            if !parts.is_empty() && parts.iter().all(|part| graph.number(*part).is_some()) {
                return Err(wrong("a constant part of it has no finite value".to_owned()));
            }
        }
    }
    Ok(())
}

/// As it would be written, without needless parentheses.
impl fmt::Display for Formula {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        self.tree.fmt(f)
    }
}

/// The same formula, not only the same function.
impl PartialEq for Formula {
    fn eq(&self, other: &Self) -> bool {
        self.tree == other.tree
    }
}
