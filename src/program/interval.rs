//! Generation of WGSL for the bounds of formulas along a piece of a path.
//!
//! *Theory.* A linear function of the coordinates cannot leave the range of its values at the ends and at several points of a path by much.
//! All others follow from it by interval arithmetic (Moore 1966): where a Gaussian or a step is thinner than the distance of the points,
//! the range of its argument shows it. Squares count among the others, because their extremes may be between distant points.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use crate::scene::{Function, Graph, Id, Node, Variable};

/// The formulas whose bounds are wanted, and the smooth functions that they consist of.
pub(super) struct Bounds<'a> {
    graph: &'a Graph,
    /// The intervals of variables that are not coordinates, in WGSL.
    others: &'a [(Variable, &'a str)],
    smooth: Vec<bool>,
    /// The smooth functions, each with the index of its range.
    pub leaves: BTreeMap<Id, usize>,
}

impl<'a> Bounds<'a> {
    /// Finds the smooth functions of these formulas.
    pub(super) fn new(graph: &'a Graph, roots: &[Id], others: &'a [(Variable, &'a str)]) -> Self {
        let reached = graph.reached(roots);
        let mut all = Self { graph, others, smooth: Vec::new(), leaves: BTreeMap::new() };
        all.smooth = vec![false; reached.last().map_or(0, |id| id.index() + 1)];
        for id in &reached {
            all.smooth[id.index()] = all.is_smooth(*id);
        }
        let inner = reached.iter().filter(|id| !all.smooth[id.index()]).flat_map(|id| graph.parts(*id));
        let wanted =
            inner.chain(roots.iter().copied()).filter(|id| all.smooth[id.index()] && graph.number(*id).is_none());
        let mut leaves: Vec<Id> = wanted.collect();
        leaves.sort_unstable();
        leaves.dedup();
        all.leaves = leaves.into_iter().enumerate().map(|(k, id)| (id, k)).collect();
        all
    }

    /// Returns `true` for linear functions of coordinates and of their products.
    fn is_smooth(&self, id: Id) -> bool {
        let is_smooth = |part: &Id| self.smooth[part.index()];
        match self.graph.node(id) {
            Node::Number(_) => true,
            Node::Variable(variable) => self.others.iter().all(|(other, _)| *other != variable),
            Node::Sum(..) | Node::Difference(..) | Node::Negative(_) => self.graph.parts(id).iter().all(is_smooth),
            Node::Product(a, b) => {
                let is_number = [a, b].iter().any(|part| self.graph.number(*part).is_some());
                let is_variable = |part: Id| matches!(self.graph.node(part), Node::Variable(_));
                // r sin θ and r cos θ are coordinates too.
                let is_coordinate = a != b && is_variable(a) && is_variable(b);
                (is_number || is_coordinate) && is_smooth(&a) && is_smooth(&b)
            }
            Node::Power(a, 1) => is_smooth(&a),
            Node::Quotient(a, b) => is_smooth(&a) && self.graph.number(b).is_some(),
            _ => false,
        }
    }

    /// Returns the lines of a function's body, and the names of the intervals of formulas; the ranges of smooth functions are in an array
    /// `ranges`.
    pub(super) fn body(&self, roots: &[Id]) -> (String, Vec<String>) {
        let mut lines = String::new();
        let mut wanted: Vec<Id> = roots.to_vec();
        let mut needed = Vec::new();
        while let Some(id) = wanted.pop() {
            if !needed.contains(&id) {
                needed.push(id);
                wanted.extend(if self.smooth[id.index()] { Vec::new() } else { self.graph.parts(id) });
            }
        }
        needed.sort_unstable();
        for id in needed {
            let _ = writeln!(lines, "    let {} = {};", name(id), self.interval(id));
        }
        (lines, roots.iter().copied().map(name).collect())
    }

    fn interval(&self, id: Id) -> String {
        if let Some(k) = self.leaves.get(&id) {
            return format!("ranges[{k}]");
        }
        let call = |function: &str, parts: &[Id]| {
            let parts: Vec<_> = parts.iter().copied().map(name).collect();
            format!("interval_{function}({})", parts.join(", "))
        };
        match self.graph.node(id) {
            Node::Number(bits) => format!("Real2({:?})", f64::from_bits(bits)),
            Node::Variable(variable) => {
                let other = self.others.iter().find(|(other, _)| *other == variable);
                other.map_or("interval_all()", |(_, text)| text).to_owned()
            }
            Node::Square | Node::Distance | Node::Direction(_) => "interval_all()".to_owned(),
            Node::Sum(a, b) => call("sum", &[a, b]),
            Node::Difference(a, b) => call("difference", &[a, b]),
            Node::Product(a, b) if a == b => call("square", &[a]),
            Node::Product(a, b) => call("product", &[a, b]),
            Node::Quotient(a, b) => match self.graph.number(b) {
                Some(divisor) => format!("interval_product({}, Real2({:?}))", name(a), divisor.recip()),
                None => call("quotient", &[a, b]),
            },
            Node::Negative(a) => call("negative", &[a]),
            Node::Power(a, k) => power(&name(a), k),
            Node::Call(function, a) => function_of(function, &name(a)),
            Node::Min(a, b) => format!("min({}, {})", name(a), name(b)),
            Node::Max(a, b) => format!("max({}, {})", name(a), name(b)),
            Node::ProgramOptions(parts) => call("choice", &parts),
        }
    }
}

fn name(id: Id) -> String {
    format!("v{}", id.index())
}

/// Returns aᵏ; even powers are powers of a².
fn power(a: &str, k: i32) -> String {
    let most = k.unsigned_abs();
    let product = match most {
        1 => a.to_owned(),
        2 => format!("interval_square({a})"),
        _ if most.is_multiple_of(2) => format!("interval_power(interval_square({a}), {}u)", most / 2),
        _ => format!("interval_power({a}, {most}u)"),
    };
    if k < 0 { format!("interval_quotient(Real2(1.0), {product})") } else { product }
}

fn function_of(function: Function, a: &str) -> String {
    match function {
        Function::Exp => format!("interval_bounded(Real2(real_exp({a}.x), real_exp({a}.y)))"),
        Function::Sinh | Function::Tanh | Function::Sign => {
            let name = function.name();
            format!("interval_bounded(Real2(formula_{name}({a}.x), formula_{name}({a}.y)))")
        }
        Function::Atan => format!("Real2(arc_tangent({a}.x, 1.0), arc_tangent({a}.y, 1.0))"),
        Function::Tan => format!("interval_quotient(interval_sin({a}), interval_cos({a}))"),
        Function::Sqrt | Function::Log | Function::Sin | Function::Cos | Function::Cosh | Function::Abs => {
            format!("interval_{}({a})", function.name())
        }
    }
}
