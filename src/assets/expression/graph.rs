//! Formulas as graphs, in which equal subexpressions are one node.
//!
//! *Practice.* Operands come before the nodes that use them, so one pass over the list of nodes evaluates all.

use super::Function;
use super::tree::{Extremum, Name, Operator, Tree};
use super::variable::Variable;
use glam::DVec3;
use std::collections::HashMap;

/// The index of a node in its graph; operands of a node come before it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Id(u32);

impl Id {
    /// Returns the index, from 0.
    #[must_use]
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// A subexpression of a formula or of its gradient.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Node {
    /// An f64, by its bits.
    Number(u64),
    /// A variable.
    Variable(Variable),
    /// r².
    Square,
    /// r.
    Distance,
    /// x/r, y/r or z/r, the derivative of r; 0 at r = 0.
    Direction(Variable),
    /// a + b.
    Sum(Id, Id),
    /// a − b.
    Difference(Id, Id),
    /// a b.
    Product(Id, Id),
    /// a/b.
    Quotient(Id, Id),
    /// −a.
    Negative(Id),
    /// aᵏ, k neither 0 nor 1.
    Power(Id, i32),
    /// f(a).
    Call(Function, Id),
    /// The smaller of two; not a number if either is not.
    Min(Id, Id),
    /// The larger of two; not a number if either is not.
    Max(Id, Id),
    /// `[a, b, c, d]`: c where a < b, else d.
    ProgramOptions([Id; 4]),
}

/// The nodes of a formula and its gradient.
#[derive(Debug, Clone, Default)]
pub struct Graph {
    nodes: Vec<Node>,
    places: HashMap<Node, Id>,
    /// The values of the names that users define.
    terms: Vec<Term>,
    /// The values of x, y, z and their differentials, for a formula with rotated axes.
    turned: Option<[Id; 6]>,
    /// Whether |x| has no derivative at 0; otherwise the derivative is 0 there.
    is_strict: bool,
}

/// The value of a name.
#[derive(Debug, Clone, Copy)]
pub(super) struct Term {
    pub value: Id,
    /// The sine and the cosine of an angle, if they can be computed without the angle.
    pub sines: Option<[Id; 2]>,
}

impl Graph {
    /// Creates a graph in which |x| has no derivative at 0.
    pub(super) fn strict() -> Self {
        Self { is_strict: true, ..Self::default() }
    }

    /// Returns `true` if |x| has no derivative at 0.
    pub(super) fn is_strict(&self) -> bool {
        self.is_strict
    }

    /// Returns a node.
    #[must_use]
    pub fn node(&self, id: Id) -> Node {
        self.nodes[id.index()]
    }

    /// Returns the value of a node that is a number.
    #[must_use]
    pub fn number(&self, id: Id) -> Option<f64> {
        match self.node(id) {
            Node::Number(bits) => Some(f64::from_bits(bits)),
            _ => None,
        }
    }

    /// Returns the nodes, each after its operands.
    pub(super) fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// Returns the operands of a node.
    #[must_use]
    pub fn parts(&self, id: Id) -> Vec<Id> {
        match self.node(id) {
            Node::Number(_) | Node::Variable(_) | Node::Square | Node::Distance | Node::Direction(_) => Vec::new(),
            Node::Negative(a) | Node::Power(a, _) | Node::Call(_, a) => vec![a],
            Node::Sum(a, b)
            | Node::Difference(a, b)
            | Node::Product(a, b)
            | Node::Quotient(a, b)
            | Node::Min(a, b)
            | Node::Max(a, b) => vec![a, b],
            Node::ProgramOptions(parts) => parts.to_vec(),
        }
    }

    /// Returns these nodes and all nodes that they depend on, each after its operands.
    #[must_use]
    pub fn reached(&self, roots: &[Id]) -> Vec<Id> {
        let mut wanted = vec![false; self.nodes.len()];
        for root in roots {
            wanted[root.index()] = true;
        }
        let all = || (0..self.nodes.len() as u32).map(Id);
        for id in all().rev() {
            if wanted[id.index()] {
                self.parts(id).into_iter().for_each(|part| wanted[part.index()] = true);
            }
        }
        all().filter(|id| wanted[id.index()]).collect()
    }

    /// Returns the values of all nodes for these values of the variables; nodes that depend on a missing variable are not numbers.
    #[must_use]
    pub fn evaluate(&self, variables: &[f64]) -> Vec<f64> {
        let mut values: Vec<f64> = Vec::with_capacity(self.nodes.len());
        let own = |variable: Variable| variables.get(usize::from(variable.0)).copied().unwrap_or(f64::NAN);
        let place = DVec3::from_array(Variable::PLACE.map(own));
        for node in &self.nodes {
            let of = |id: Id| values[id.index()];
            values.push(match *node {
                Node::Number(bits) => f64::from_bits(bits),
                Node::Variable(a) => own(a),
                Node::Square => place.length_squared(),
                Node::Distance => place.length(),
                Node::Direction(a) => own(a) / place.length().max(f64::MIN_POSITIVE),
                Node::Sum(a, b) => of(a) + of(b),
                Node::Difference(a, b) => of(a) - of(b),
                Node::Product(a, b) => of(a) * of(b),
                Node::Quotient(a, b) => of(a) / of(b),
                Node::Negative(a) => -of(a),
                Node::Power(a, k) => of(a).powi(k),
                Node::Call(function, a) => function.of(of(a)),
                Node::Min(a, b) | Node::Max(a, b) if of(a).is_nan() || of(b).is_nan() => f64::NAN,
                Node::Min(a, b) => of(a).min(of(b)),
                Node::Max(a, b) => of(a).max(of(b)),
                Node::ProgramOptions([a, b, c, d]) => {
                    if of(a) < of(b) {
                        of(c)
                    } else {
                        of(d)
                    }
                }
            });
        }
        values
    }

    /// Returns the node of a tree.
    pub(super) fn of_tree(&mut self, tree: &Tree) -> Id {
        match tree {
            Tree::Number(value) => self.constant(*value),
            Tree::Name(Name::Variable(_, variable)) => match self.turned {
                Some(turned) if usize::from(variable.0) < turned.len() => turned[usize::from(variable.0)],
                _ => self.make(Node::Variable(*variable)),
            },
            Tree::Term(_, k) => self.terms[*k].value,
            Tree::Name(Name::R) => self.make(Node::Distance),
            Tree::Name(Name::Pi) => self.constant(std::f64::consts::PI),
            Tree::Negative(a) => {
                let a = self.of_tree(a);
                self.negative(a)
            }
            Tree::Call(function, a) => {
                if let Some(known) = self.known_call(*function, a) {
                    return known;
                }
                let a = self.of_tree(a);
                self.call(*function, a)
            }
            Tree::Binary(operator, a, b) => {
                let (a, b) = (self.of_tree(a), self.of_tree(b));
                match operator {
                    Operator::Plus => self.sum(a, b),
                    Operator::Minus => self.difference(a, b),
                    Operator::Times => self.product(a, b),
                    Operator::Over => self.quotient(a, b),
                    Operator::Power => self.raised(a, b),
                }
            }
            Tree::Extremum(extreme, a, b) => {
                let (a, b) = (self.of_tree(a), self.of_tree(b));
                let node = if *extreme == Extremum::Min { Node::Min(a, b) } else { Node::Max(a, b) };
                self.folded(node)
            }
        }
    }

    /// Returns the value of a trigonometric function of an angle, computed without the angle.
    fn known_call(&mut self, function: Function, a: &Tree) -> Option<Id> {
        let Tree::Term(_, k) = a else { return None };
        let [sine, cosine] = self.terms[*k].sines?;
        match function {
            Function::Sin => Some(sine),
            Function::Cos => Some(cosine),
            Function::Tan => Some(self.quotient(sine, cosine)),
            _ => None,
        }
    }

    /// Defines the value of the next user-defined name.
    pub(super) fn define(&mut self, term: Term) {
        self.terms.push(term);
    }

    /// Replaces x, y, z and their differentials from here on.
    pub(super) fn turn(&mut self, turned: [Id; 6]) {
        self.turned = Some(turned);
    }

    /// Returns the index of a node, which may exist already.
    pub(super) fn make(&mut self, node: Node) -> Id {
        if let Some(known) = self.places.get(&node) {
            return *known;
        }
        let id = Id(self.nodes.len() as u32);
        self.nodes.push(node);
        self.places.insert(node, id);
        id
    }
}
