//! Spacetimes as written: the texts of the line element, the scale and the capture condition, and the names in them.

use std::ops::Range;

use glam::DMat3;

use super::graph::Term;
use super::tokens::wrong;
use super::tree::{Name, Tree};
use super::{FormulaError, Function, Graph, Id, Language, Node, Variable, parse};

/// The built-in names except x, y, z and t, with their formulas; for angles, the sine and the cosine are computed without the angle.
const KNOWN: [(&str, &str, Option<[&str; 2]>); 8] = [
    ("rho", "sqrt(x^2 + y^2)", None),
    ("theta", "2 * atan(rho / (r + z))", Some(["rho / r", "z / r"])),
    ("phi", "2 * atan(y / (rho + x))", Some(["y / rho", "x / rho"])),
    ("dr", "(x*dx + y*dy + z*dz) / r", None),
    ("drho", "(x*dx + y*dy) / rho", None),
    ("dphi", "(x*dy - y*dx) / (x^2 + y^2)", None),
    ("dtheta", "(z*drho - rho*dz) / r^2", None),
    ("dOmega2", "(dx^2 + dy^2 + dz^2 - dr^2) / r^2", None),
];

/// The largest number of names that a spacetime may define; the parser searches all of them.
const MOST_NAMES: usize = 200;

/// The variables of functions of position and time.
pub(super) const PLACE: [Name; 6] = [
    Name::Variable("x", Variable::PLACE[0]),
    Name::Variable("y", Variable::PLACE[1]),
    Name::Variable("z", Variable::PLACE[2]),
    Name::Variable("t", Variable::TIME),
    Name::R,
    Name::Pi,
];

/// These variables and the differentials.
pub(super) const ALL: [Name; 10] = [
    PLACE[0],
    PLACE[1],
    PLACE[2],
    PLACE[3],
    Name::Variable("dx", Variable::DIFFERENTIALS[0]),
    Name::Variable("dy", Variable::DIFFERENTIALS[1]),
    Name::Variable("dz", Variable::DIFFERENTIALS[2]),
    Name::Variable("dt", Variable::DIFFERENTIALS[3]),
    PLACE[4],
    PLACE[5],
];

/// A spacetime as written.
#[derive(Debug, Clone, PartialEq)]
pub struct Spacetime {
    /// ds².
    pub line_element: String,
    /// The parameters: names for numbers.
    pub parameters: Vec<(String, f64)>,
    /// The names for formulas; each formula may use the names before it.
    pub terms: Vec<(String, String)>,
    /// The characteristic length scale.
    pub scale: String,
    /// The capture condition, at which rays end: `a < b` or `a > b`.
    pub captured: Option<String>,
    /// The radius of the sphere that represents a throat, if there is one.
    pub throat: Option<f64>,
    /// The axes of x, y and z, in columns.
    pub axes: DMat3,
}

/// The text that contains an error.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Field {
    /// ds².
    LineElement,
    /// A name for a number.
    Parameter(usize),
    /// A name for a formula.
    TermName(usize),
    /// A formula with a name.
    Term(usize),
    /// The scale.
    Scale,
    /// The capture condition.
    Captured,
}

/// A text, and the error in it.
pub(super) type Wrong = (Field, FormulaError);

/// A parser of the texts that stores the values of their names.
pub(super) struct Reader {
    pub graph: Graph,
    terms: Vec<String>,
}

impl Reader {
    pub fn new(axes: DMat3) -> Self {
        let mut graph = Graph::strict();
        if axes != DMat3::IDENTITY {
            let [dx, dy, dz, _] = Variable::DIFFERENTIALS;
            let [place, change] = [Variable::PLACE, [dx, dy, dz]].map(|own| {
                [0, 1, 2].map(|k: usize| {
                    let mut sum = graph.constant(0.0);
                    for (axis, part) in own.into_iter().zip(axes.col(k).to_array()) {
                        let (part, axis) = (graph.constant(part), graph.make(Node::Variable(axis)));
                        let product = graph.product(part, axis);
                        sum = graph.sum(sum, product);
                    }
                    sum
                })
            });
            let ([x, y, z], [dx, dy, dz]) = (place, change);
            graph.turn([x, y, z, dx, dy, dz]);
        }
        Self { graph, terms: Vec::new() }
    }

    fn language(&self, names: &'static [Name]) -> Language {
        let example = if names.len() == ALL.len() { "-dt^2 + dx^2 + dy^2 + dz^2" } else { "r - 2" };
        Language { names, example, terms: self.terms.clone() }
    }

    /// Returns a parser of functions of these names, without the names of line elements.
    pub fn plain() -> Self {
        Self { graph: Graph::strict(), terms: Vec::new() }
    }

    pub fn tree(&self, text: &str, names: &'static [Name]) -> Result<Tree, FormulaError> {
        parse::parse(text, &self.language(names))
    }

    pub fn define(&mut self, name: &str, value: Id, sines: Option<[Id; 2]>) {
        self.terms.push(name.to_owned());
        self.graph.define(Term { value, sines });
    }

    pub fn name_all(&mut self, written: &Spacetime) -> Result<(), Wrong> {
        for (name, text, sines) in KNOWN {
            let mut of = |text: &str| {
                let tree = self.tree(text, &ALL).map_err(|error| (Field::LineElement, error))?;
                Ok(self.graph.of_tree(&tree))
            };
            let value = of(text)?;
            let sines = match sines {
                Some([sine, cosine]) => Some([of(sine)?, of(cosine)?]),
                None => None,
            };
            self.define(name, value, sines);
        }
        if let Some(throat) = written.throat {
            self.define_distance(throat).map_err(|error| (Field::LineElement, error))?;
        }
        let (named, parameters) = (written.parameters.len() + written.terms.len(), written.parameters.len());
        if named > MOST_NAMES {
            let field = if parameters > MOST_NAMES {
                Field::Parameter(MOST_NAMES)
            } else {
                Field::TermName(MOST_NAMES - parameters)
            };
            let problem = format!("{named} parameters and terms exceed the limit of {MOST_NAMES}");
            return Err((field, wrong(0..0, problem, "")));
        }
        for (k, (name, value)) in written.parameters.iter().enumerate() {
            self.is_new(name, &ALL).map_err(|error| (Field::Parameter(k), error))?;
            let value = self.graph.constant(*value);
            self.define(name, value, None);
        }
        for (k, (name, text)) in written.terms.iter().enumerate() {
            self.is_new(name, &ALL).map_err(|error| (Field::TermName(k), error))?;
            let tree = self.tree(text, &ALL).map_err(|error| (Field::Term(k), error))?;
            let value = self.graph.of_tree(&tree);
            self.define(name, value, None);
        }
        Ok(())
    }

    /// Defines `l` and `dl`: l is the distance from a throat, negative on the far side. On each side r is the throat's radius plus |l|.
    fn define_distance(&mut self, throat: f64) -> Result<(), FormulaError> {
        let graph = &mut self.graph;
        let [side, radius] = [graph.make(Node::Variable(Variable::SIDE)), graph.constant(throat)];
        let away = graph.make(Node::Distance);
        let beyond = graph.difference(away, radius);
        let distance = graph.product(side, beyond);
        self.define("l", distance, None);
        let tree = self.tree("dr", &ALL)?;
        let rising = self.graph.of_tree(&tree);
        let rising = self.graph.product(side, rising);
        self.define("dl", rising, None);
        Ok(())
    }

    /// Checks that a name is valid and not defined yet, by these names or by the user.
    pub fn is_new(&self, name: &str, names: &'static [Name]) -> Result<(), FormulaError> {
        let place = 0..name.len();
        let is_name = name.starts_with(|c: char| c.is_ascii_alphabetic())
            && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
        if !is_name {
            let help = "use letters, digits and underscores, and begin with a letter";
            return Err(wrong(place, format!("`{name}` is not a valid name"), help));
        }
        let mut functions = Function::WRITTEN.iter().map(|(text, _)| *text).chain(["min", "max"]);
        if self.language(names).named(name).is_some() || functions.any(|known| known == name) {
            return Err(wrong(place, format!("`{name}` is already defined"), "use another name"));
        }
        Ok(())
    }

    /// Parses a comparison, and returns the smaller side and the larger.
    pub fn comparison(&self, text: &str) -> Result<[Tree; 2], FormulaError> {
        let signs: Vec<(usize, char)> = text.char_indices().filter(|(_, c)| matches!(c, '<' | '>')).collect();
        let [(at, sign)] = signs[..] else {
            let problem = "expected one < or > between two formulas";
            return Err(wrong(0..text.len(), problem, "for example r < 2.02"));
        };
        let side = |part: Range<usize>| {
            let moved = |place: Range<usize>| part.start + place.start..part.start + place.end;
            let tree = self.tree(&text[part.clone()], &PLACE);
            tree.map_err(|error| FormulaError { place: moved(error.place), ..error })
        };
        let [left, right] = [side(0..at)?, side(at + 1..text.len())?];
        Ok(if sign == '<' { [left, right] } else { [right, left] })
    }
}
