//! The formulas of a volume: its density, emission, absorption and motion, as functions of position, time and the frequency of light.
//!
//! *Practice.* All formulas of a volume share one graph, so that equal subexpressions are one node. Emission and absorption are usually
//! powers of the frequency: then the program needs one value for all frequencies.

use super::spacetime::Reader;
use super::tree::Name;
use super::volume_texts::{VolumeField, VolumeTexts};
use super::{FormulaError, Function, Graph, Id, Node, Variable, check};

/// The variables of functions of position and time, by their index in [`VolumeFormulas::VARIABLES`].
const PLACE: [Name; 7] = [
    Name::Variable("x", Variable(0)),
    Name::Variable("y", Variable(1)),
    Name::Variable("z", Variable(2)),
    Name::Variable("t", TIME),
    Name::Variable("r", Variable(4)),
    Name::Variable("rho", Variable(5)),
    Name::Pi,
];
/// The sine and the cosine of the polar angle.
const POLAR: [Variable; 2] = [Variable(6), Variable(7)];
const TIME: Variable = Variable(3);
const DENSITY: Variable = VolumeFormulas::DENSITY;
const NU: Variable = VolumeFormulas::NU;

/// These variables, the density and the frequency.
const ALL: [Name; 9] = [
    PLACE[0],
    PLACE[1],
    PLACE[2],
    PLACE[3],
    PLACE[4],
    PLACE[5],
    PLACE[6],
    Name::Variable("n", DENSITY),
    Name::Variable("nu", NU),
];

/// The largest number of grids of a volume.
pub const MOST_GRIDS: usize = 8;
/// The variable of the first grid.
const GRIDS: u8 = 10;

/// The formulas of a volume.
#[derive(Debug, Clone)]
pub struct VolumeFormulas {
    texts: VolumeTexts,
    graph: Graph,
    /// The density n.
    pub density: Id,
    /// The emission and the absorption of each channel.
    pub coefficients: Vec<Coefficients>,
    /// The temperature.
    pub temperature: Option<Id>,
    /// The motion.
    pub flow: Vec<Id>,
}

/// The emission and the absorption of one channel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Coefficients {
    /// The emission, per unit length.
    pub emission: Id,
    /// The absorption, per unit length.
    pub absorption: Id,
}

impl VolumeFormulas {
    /// The density n, the first variable that is not of a position.
    pub const DENSITY: Variable = Variable(8);
    /// The frequency ν/ν₀.
    pub const NU: Variable = Variable(9);
    /// The names of the variables in WGSL, of which the samples on grids are the last.
    pub const VARIABLES: [&'static str; 10 + MOST_GRIDS] = [
        "p.q.x",
        "p.q.y",
        "p.q.z",
        "p.time",
        "p.r",
        "p.rho",
        "p.sine",
        "p.cosine",
        "n",
        "nu",
        "p.grids[0]",
        "p.grids[1]",
        "p.grids[2]",
        "p.grids[3]",
        "p.grids[4]",
        "p.grids[5]",
        "p.grids[6]",
        "p.grids[7]",
    ];

    /// Parses the formulas.
    ///
    /// # Errors
    ///
    /// The first error, with the text that contains it.
    pub fn parse(texts: VolumeTexts) -> Result<Self, (VolumeField, FormulaError)> {
        Self::of(texts, &ALL)
    }

    /// Parses the absorption of a medium, one formula for all channels or one for each of three.
    ///
    /// # Errors
    ///
    /// The first error, with the index of the text that contains it.
    pub fn of_medium(absorption: Vec<String>) -> Result<Self, (usize, FormulaError)> {
        let texts = VolumeTexts {
            density: "1".to_owned(),
            emission: vec!["0".to_owned()],
            absorption,
            ..VolumeTexts::default()
        };
        Self::of(texts, &PLACE).map_err(|(field, error)| match field {
            VolumeField::Absorption(k) => (k, error),
            _ => (0, error),
        })
    }

    /// Parses the formulas; those of emission and absorption have the variables `names`.
    fn of(texts: VolumeTexts, names: &'static [Name]) -> Result<Self, (VolumeField, FormulaError)> {
        let mut reader = Reader::plain();
        name_angles(&mut reader).map_err(|error| (VolumeField::Density, error))?;
        for (k, (name, value)) in texts.parameters.iter().enumerate() {
            reader.is_new(name, &ALL).map_err(|error| (VolumeField::Parameter(k), error))?;
            let value = reader.graph.constant(*value);
            reader.define(name, value, None);
        }
        for (k, name) in texts.grids.iter().enumerate() {
            reader.is_new(name, &ALL).map_err(|error| (VolumeField::GridName(k), error))?;
            let value = reader.graph.make(Node::Variable(Variable(GRIDS + k as u8)));
            reader.define(name, value, None);
        }
        let of = |reader: &mut Reader, text: &str, names: &'static [Name], field: VolumeField| {
            let tree = reader.tree(text, names).map_err(|error| (field, error))?;
            let id = reader.graph.of_tree(&tree);
            check(text, &reader.graph, &[id]).map_err(|error| (field, error))?;
            Ok(id)
        };
        for (k, (name, text)) in texts.terms.iter().enumerate() {
            reader.is_new(name, &ALL).map_err(|error| (VolumeField::TermName(k), error))?;
            let value = of(&mut reader, text, &PLACE, VolumeField::Term(k))?;
            reader.define(name, value, None);
        }
        let density = of(&mut reader, &texts.density, &PLACE, VolumeField::Density)?;
        let mut all = |texts: &[String], names: &'static [Name], field: fn(usize) -> VolumeField| {
            let each = texts.iter().enumerate().map(|(k, text)| of(&mut reader, text, names, field(k)));
            each.collect::<Result<Vec<Id>, _>>()
        };
        let emission = all(&texts.emission, names, VolumeField::Emission)?;
        let absorption = all(&texts.absorption, names, VolumeField::Absorption)?;
        let flow = all(&texts.flow, &PLACE, VolumeField::Flow)?;
        let temperature = texts.temperature.as_ref();
        let temperature =
            temperature.map(|text| of(&mut reader, text, &PLACE, VolumeField::Temperature)).transpose()?;
        let channel = |all: &[Id], k: usize| all[k.min(all.len() - 1)];
        let channels = emission.len().max(absorption.len());
        let coefficients = (0..channels)
            .map(|k| Coefficients { emission: channel(&emission, k), absorption: channel(&absorption, k) })
            .collect();
        Ok(Self { texts, graph: reader.graph, density, coefficients, temperature, flow })
    }

    /// Returns the formulas as written.
    #[must_use]
    pub fn texts(&self) -> &VolumeTexts {
        &self.texts
    }

    /// Returns the graph of all formulas.
    #[must_use]
    pub fn graph(&self) -> &Graph {
        &self.graph
    }

    /// Returns the first text that contains the frequency.
    #[must_use]
    pub fn with_frequency(&self) -> Option<VolumeField> {
        let fields = self.coefficients.iter().enumerate().flat_map(|(k, channel)| {
            [(VolumeField::Emission(k), channel.emission), (VolumeField::Absorption(k), channel.absorption)]
        });
        fields.into_iter().find(|(_, id)| self.depends_on(*id, NU)).map(|(field, _)| field)
    }

    /// Returns the formulas of the density, the emission, the absorption and the temperature.
    #[must_use]
    pub fn light(&self) -> Vec<Id> {
        let channels = self.coefficients.iter().flat_map(|channel| [channel.emission, channel.absorption]);
        channels.chain([self.density]).chain(self.temperature).collect()
    }

    /// Returns `true` if some formula depends on the time.
    #[must_use]
    pub fn changes(&self) -> bool {
        let all = [self.light(), self.flow.clone()].concat();
        self.contain(&all, |node| node == Node::Variable(TIME))
    }

    /// Returns `true` if the emission or the absorption depends on position or time.
    #[must_use]
    pub fn varies(&self) -> bool {
        self.contain(
            &self.light(),
            |node| matches!(node, Node::Variable(variable) if ![DENSITY, NU].contains(&variable)),
        )
    }

    /// Returns `true` if emission or absorption may have edges, beyond which there is none.
    #[must_use]
    pub fn has_edges(&self) -> bool {
        let is_grid = |variable: Variable| variable.0 >= GRIDS;
        let is_edge = |node| match node {
            Node::Min(..) | Node::Max(..) | Node::Call(Function::Abs, _) => true,
            Node::Variable(variable) => is_grid(variable),
            _ => false,
        };
        self.contain(&self.light(), is_edge)
    }

    fn contain(&self, roots: &[Id], is_wanted: impl Fn(Node) -> bool) -> bool {
        self.graph.reached(roots).into_iter().any(|id| is_wanted(self.graph.node(id)))
    }

    /// Returns `true` if nothing emits light.
    #[must_use]
    pub fn is_dark(&self) -> bool {
        let is_none = |id: Id| self.graph.number(id) == Some(0.0);
        self.temperature.is_none() && self.coefficients.iter().all(|channel| is_none(channel.emission))
    }

    /// Returns the absorption of the first channel if it is constant.
    #[must_use]
    pub fn absorption_constant(&self) -> Option<f64> {
        self.graph.number(self.coefficients[0].absorption)
    }

    /// Returns `true` if nothing absorbs light.
    #[must_use]
    pub fn is_clear(&self) -> bool {
        self.coefficients.iter().all(|channel| self.graph.number(channel.absorption) == Some(0.0))
    }

    fn depends_on(&self, root: Id, variable: Variable) -> bool {
        self.contain(&[root], |node| node == Node::Variable(variable))
    }

    /// Returns the powers of ν to which the emission and the absorption are proportional.
    #[must_use]
    pub fn exponents(&self) -> Option<[f64; 2]> {
        let [channel] = self.coefficients[..] else { return None };
        let is_black = self.temperature.is_some();
        (!is_black).then(|| Some([self.exponent(channel.emission)?, self.exponent(channel.absorption)?]))?
    }

    /// Returns p if a formula is proportional to νᵖ.
    fn exponent(&self, id: Id) -> Option<f64> {
        if !self.depends_on(id, NU) {
            return Some(0.0);
        }
        match self.graph.node(id) {
            Node::Variable(_) => Some(1.0),
            Node::Negative(a) => self.exponent(a),
            Node::Product(a, b) => Some(self.exponent(a)? + self.exponent(b)?),
            Node::Quotient(a, b) => Some(self.exponent(a)? - self.exponent(b)?),
            Node::Power(a, k) => Some(self.exponent(a)? * f64::from(k)),
            Node::Sum(a, b) | Node::Difference(a, b) => {
                let (a, b) = (self.exponent(a)?, self.exponent(b)?);
                (a.to_bits() == b.to_bits()).then_some(a)
            }
            Node::Call(Function::Sqrt, a) => Some(0.5 * self.exponent(a)?),
            // Other powers are e^(p log ν).
            Node::Call(Function::Exp, a) => self.of_logarithm(a),
            _ => None,
        }
    }

    /// Returns p of p log ν.
    fn of_logarithm(&self, id: Id) -> Option<f64> {
        match self.graph.node(id) {
            Node::Call(Function::Log, a) => self.exponent(a),
            Node::Negative(a) => Some(-self.of_logarithm(a)?),
            Node::Product(a, b) => Some(self.graph.number(a)? * self.of_logarithm(b)?),
            _ => None,
        }
    }

    /// Returns the values of all nodes at a position: of x, y, z, t, r, rho, sin θ, cos θ, n, ν and the grids.
    #[must_use]
    pub fn values(&self, variables: &[f64]) -> Vec<f64> {
        self.graph.evaluate(variables)
    }
}

/// Defines theta and phi, whose sines and cosines need no angle.
fn name_angles(reader: &mut Reader) -> Result<(), FormulaError> {
    let [sine, cosine] = POLAR.map(|variable| reader.graph.make(Node::Variable(variable)));
    let one = reader.graph.constant(1.0);
    let half = reader.graph.sum(one, cosine);
    let half = reader.graph.quotient(sine, half);
    let half = reader.graph.call(Function::Atan, half);
    let theta = reader.graph.sum(half, half);
    reader.define("theta", theta, Some([sine, cosine]));
    let mut of = |text: &str| {
        let tree = reader.tree(text, &PLACE)?;
        Ok(reader.graph.of_tree(&tree))
    };
    let (phi, sine, cosine) =
        (of("2 * atan(y / (sqrt(x^2 + y^2) + x))")?, of("y / sqrt(x^2 + y^2)")?, of("x / sqrt(x^2 + y^2)")?);
    reader.define("phi", phi, Some([sine, cosine]));
    Ok(())
}

/// Formulas are equal if their texts are.
impl PartialEq for VolumeFormulas {
    fn eq(&self, other: &Self) -> bool {
        self.texts == other.texts
    }
}
