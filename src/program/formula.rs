//! Generation of WGSL for formulas, with their gradients and common subexpressions, and for curves.
//!
//! *Practice.* Nodes of the formula's graph that are used more than once become a `let`; all others are written inline.
//! Powers are expanded by repeated squaring. Numbers are written as a `Real` of either precision, because WGSL treats a bare literal as an
//! f32 if nothing next to it determines its type.
//!
//! *Length.* Over 300 lines, because values, gradients and curves are written from the same graph by the same rules.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use super::generated::{switch, unit};
use super::unit::Unit;
use crate::assets::VolumeFormulas;
use crate::scene::{Curve, FanRay, Formula, Function, Graph, Id, Node, Variable};

/// Generates `formula(q)`: gradient and value at q, of the formula with the index `place`.
pub(super) fn formulas(formulas: &[Formula]) -> Unit {
    let mut text = String::new();
    let mut calls = Vec::new();
    for (k, formula) in formulas.iter().enumerate() {
        let _ = writeln!(text, "// ∇n and n = {formula}\n{}", function(&format!("formula_{k}"), formula));
        calls.push((format!("{k}u"), format!("formula_{k}(q)")));
    }
    text += &switch("fn formula(q: Real3) -> Real4", "place", &calls);
    unit("generated/formula.wgsl", text)
}

/// Generates `curve_point(t)`, the position and velocity, and `curve_pull(t)`, the acceleration.
pub(super) fn curve(curve: &Curve) -> Unit {
    let written = |orders: &[usize]| {
        let graph = curve.graph(0).0;
        let roots: Vec<Id> = orders.iter().flat_map(|order| curve.graph(*order).1).collect();
        let (lines, values) = body(graph, &roots, &["t"]);
        (lines, values.chunks(3).map(|place| format!("Real3({})", place.join(", "))).collect::<Vec<_>>())
    };
    let ((lines, point), (more, pull)) = (written(&[0, 1]), written(&[2]));
    let text = format!(
        "// ({})\nfn curve_point(t: Real) -> mat2x3<Real> {{\n{lines}    return mat2x3<Real>({});\n}}\n\n\
         fn curve_pull(t: Real) -> Real3 {{\n{more}    return {};\n}}\n",
        curve.texts().join(", "),
        point.join(", "),
        pull.join(""),
    );
    unit("generated/curve.wgsl", text)
}

/// Generates `fan_count(which)`, and `fan_ray(which, i, d, n)`: direction and weight.
pub(super) fn fans(fans: &[&[FanRay]]) -> Unit {
    let (mut text, mut rays, mut counts) = (String::new(), Vec::new(), Vec::new());
    for (which, own) in fans.iter().enumerate() {
        let mut calls = Vec::new();
        for (i, ray) in own.iter().enumerate() {
            let (graph, roots) = ray.graph();
            let (lines, values) = body(graph, &roots, &["d.x", "d.y", "d.z", "n.x", "n.y", "n.z", "c"]);
            let _ = writeln!(
                text,
                "fn fan_{which}_{i}(d: Real3, n: Real3) -> Real4 {{\n    let c = -dot(d, n);\n{lines}    return Real4({});\n}}\n",
                values.join(", ")
            );
            calls.push((format!("{i}u"), format!("fan_{which}_{i}(d, n)")));
        }
        text += &switch(&format!("fn fan_{which}(i: u32, d: Real3, n: Real3) -> Real4"), "i", &calls);
        rays.push((format!("{which}u"), format!("fan_{which}(i, d, n)")));
        counts.push((format!("{which}u"), format!("{}u", own.len())));
    }
    text += &switch("fn fan_ray(which: u32, i: u32, d: Real3, n: Real3) -> Real4", "which", &rays);
    text += &switch("fn fan_count(which: u32) -> u32", "which", &counts);
    unit("generated/fans.wgsl", text)
}

/// A conversion in a separate function, because naga does not convert a 64-bit constant to 32 bits; an argument is not a constant.
const ROUNDED: &str = "fn absorption_rounded(value: Real) -> f32 {\n    return f32(value);\n}\n\n";

/// Generates `absorption_formula(which, p)`: three numbers, one for each channel.
pub(super) fn absorptions(absorptions: &[&VolumeFormulas]) -> Unit {
    let (mut text, mut calls) = (ROUNDED.to_owned(), Vec::new());
    for (which, formulas) in absorptions.iter().enumerate() {
        let roots: Vec<Id> = formulas.coefficients.iter().map(|channel| channel.absorption).collect();
        let (lines, values) = body(formulas.graph(), &roots, &VolumeFormulas::VARIABLES);
        let all: Vec<_> = values.iter().map(|value| format!("absorption_rounded({value})")).collect();
        let _ = writeln!(
            text,
            "fn absorption_{which}(p: MatterPlace) -> vec3f {{\n{lines}    return vec3f({});\n}}\n",
            all.join(", ")
        );
        calls.push((format!("{which}u"), format!("absorption_{which}(p)")));
    }
    text += &switch("fn absorption_formula(which: u32, p: MatterPlace) -> vec3f", "which", &calls);
    unit("generated/absorption_formulas.wgsl", text)
}

fn function(name: &str, formula: &Formula) -> String {
    let (graph, roots) = formula.graph();
    let (lines, values) = body(graph, &roots, &["q.x", "q.y", "q.z"]);
    format!("fn {name}(q: Real3) -> Real4 {{\n{lines}    return Real4({});\n}}\n", values.join(", "))
}

/// Returns the lines of a function's body, and the expressions of the nodes `roots`; `variables` are the names of the variables in WGSL.
pub(super) fn body(graph: &Graph, roots: &[Id], variables: &'static [&'static str]) -> (String, Vec<String>) {
    let reached = graph.reached(roots);
    let uses = uses(graph, &reached, roots);
    let divides = divides(graph, &reached);
    let (names, depths) = (BTreeMap::new(), BTreeMap::new());
    let mut writer = Writer { graph, variables, uses, divides, names, depths, lines: String::new() };
    writer.common_places(&reached);
    for id in reached {
        writer.bind(id);
    }
    let values = roots.iter().map(|id| writer.argument(*id)).collect();
    (writer.lines, values)
}

/// Counts how often each node would be written inline.
fn uses(graph: &Graph, reached: &[Id], roots: &[Id]) -> BTreeMap<Id, usize> {
    let mut uses = BTreeMap::new();
    let parts = reached.iter().flat_map(|id| graph.parts(*id));
    for id in parts.chain(roots.iter().copied()) {
        *uses.entry(id).or_default() += 1;
    }
    // Repeated squaring writes its base several times, and so do sines and cosines of one angle.
    for id in reached {
        if let Node::Power(a, _) | Node::Call(Function::Sin | Function::Cos | Function::Tan, a) = graph.node(*id) {
            *uses.entry(a).or_default() += 1;
        }
    }
    uses
}

/// Counts how often each node is a divisor: a division takes as long as several products, so one reciprocal replaces all of them.
fn divides(graph: &Graph, reached: &[Id]) -> BTreeMap<Id, usize> {
    let mut divides = BTreeMap::new();
    for id in reached {
        if let Node::Quotient(_, b) = graph.node(*id)
            && graph.number(b).is_none()
        {
            *divides.entry(b).or_default() += 1;
        }
    }
    divides
}

/// The precedence of a piece of WGSL.
const SUM: u8 = 1;
const PRODUCT: u8 = 2;
const MINUS: u8 = 3;
const WHOLE: u8 = 4;

/// The largest depth of nested expressions; WGSL compilers reject hundreds of levels.
const DEEPEST: usize = 32;

struct Writer<'a> {
    graph: &'a Graph,
    variables: &'static [&'static str],
    uses: BTreeMap<Id, usize>,
    divides: BTreeMap<Id, usize>,
    /// The names of bound nodes.
    names: BTreeMap<Key, String>,
    /// The depth of the expressions that are not bound.
    depths: BTreeMap<Id, usize>,
    lines: String,
}

/// A value that a name can be bound to.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
enum Key {
    Node(Id),
    Power(Id, u32),
    /// The sine and cosine of a node.
    Sines(Id),
    /// The reciprocal of a node.
    Inverse(Id),
}

impl Writer<'_> {
    /// Binds r², r and the direction, which are functions of all three coordinates.
    fn common_places(&mut self, reached: &[Id]) {
        let has = |wanted: fn(&Node) -> bool| reached.iter().any(|id| wanted(&self.graph.node(*id)));
        let direction = has(|node| matches!(node, Node::Direction(_)));
        if has(|node| *node == Node::Square) {
            self.lines += "    let square = dot(q, q);\n";
        }
        if direction || has(|node| *node == Node::Distance) {
            self.lines += "    let r = length(q);\n";
        }
        if direction {
            self.lines += "    let outward = q / max(r, 1e-30);\n";
        }
    }

    /// Binds a name to the node if it is used again, or if its expression would be too deep.
    fn bind(&mut self, id: Id) {
        let parts = self.graph.parts(id);
        let inside = parts.iter().filter_map(|part| self.depths.get(part)).max().map_or(0, |depth| depth + 1);
        let is_used_again = self.uses.get(&id).is_some_and(|uses| *uses > 1);
        if parts.is_empty() || !(is_used_again || inside == DEEPEST) {
            self.depths.insert(id, inside);
            return;
        }
        let (text, _) = self.piece(id);
        // Powers and sines have names already.
        let named = text.chars().all(|c| c.is_ascii_alphanumeric() || c == '.');
        let name = if named { text } else { self.line(&text) };
        self.names.insert(Key::Node(id), name);
    }

    fn line(&mut self, text: &str) -> String {
        let name = format!("a{}", self.names.len());
        let _ = writeln!(self.lines, "    let {name} = {text};");
        name
    }

    /// Returns the node as an operand: in parentheses if its precedence is below `strength`.
    fn operand(&mut self, id: Id, strength: u8) -> String {
        let (text, own) = self.named(id);
        if own < strength { format!("({text})") } else { text }
    }

    /// Returns the node as an argument, which is a `Real` by itself.
    fn argument(&mut self, id: Id) -> String {
        match self.graph.number(id) {
            Some(value) => format!("Real({value:?})"),
            None => self.named(id).0,
        }
    }

    fn named(&mut self, id: Id) -> (String, u8) {
        match self.names.get(&Key::Node(id)) {
            Some(name) => (name.clone(), WHOLE),
            None => self.piece(id),
        }
    }

    fn piece(&mut self, id: Id) -> (String, u8) {
        let own = |variable: Variable| self.variables.get(usize::from(variable.0)).copied().unwrap_or("");
        match self.graph.node(id) {
            Node::Number(bits) => {
                let value = f64::from_bits(bits);
                (format!("{value:?}"), if value < 0.0 { MINUS } else { WHOLE })
            }
            Node::Variable(a) => (own(a).to_owned(), WHOLE),
            Node::Square => ("square".to_owned(), WHOLE),
            Node::Distance => ("r".to_owned(), WHOLE),
            Node::Direction(a) => (format!("outward.{}", ["x", "y", "z"][usize::from(a.0)]), WHOLE),
            Node::Sum(a, b) => (format!("{} + {}", self.operand(a, SUM), self.operand(b, PRODUCT)), SUM),
            Node::Difference(a, b) => (format!("{} - {}", self.operand(a, SUM), self.operand(b, PRODUCT)), SUM),
            Node::Product(a, b) => (format!("{} * {}", self.operand(a, PRODUCT), self.operand(b, WHOLE)), PRODUCT),
            Node::Quotient(a, b) if self.divides.get(&b).is_some_and(|divides| *divides > 2) => {
                (format!("{} * {}", self.operand(a, PRODUCT), self.inverse(b)), PRODUCT)
            }
            Node::Quotient(a, b) => (format!("{} / {}", self.operand(a, PRODUCT), self.operand(b, WHOLE)), PRODUCT),
            Node::Negative(a) => (format!("-{}", self.operand(a, WHOLE)), MINUS),
            Node::Power(a, k) => {
                let power = self.power(a, k.unsigned_abs());
                if k < 0 { (format!("1.0 / {power}"), PRODUCT) } else { (power, WHOLE) }
            }
            Node::Call(function, a) => self.call(function, a),
            Node::Min(a, b) => (format!("formula_min({}, {})", self.argument(a), self.argument(b)), WHOLE),
            Node::Max(a, b) => (format!("formula_max({}, {})", self.argument(a), self.argument(b)), WHOLE),
            Node::ProgramOptions([a, b, c, d]) => {
                let [a, b, c, d] = [a, b, c, d].map(|id| self.argument(id));
                (format!("select({d}, {c}, {a} < {b})"), WHOLE)
            }
        }
    }

    /// Returns the name of aᵏ, k ≥ 1.
    fn power(&mut self, a: Id, k: u32) -> String {
        if k == 1 {
            return self.operand(a, WHOLE);
        }
        if let Some(name) = self.names.get(&Key::Power(a, k)) {
            return name.clone();
        }
        // Odd powers are products with the even power below, which their derivative contains.
        let (one, other) = if k.is_multiple_of(2) { (k / 2, k / 2) } else { (k - 1, 1) };
        let (one, other) = (self.power(a, one), self.power(a, other));
        let name = self.line(&format!("{one} * {other}"));
        self.names.insert(Key::Power(a, k), name.clone());
        name
    }

    fn inverse(&mut self, a: Id) -> String {
        if let Some(name) = self.names.get(&Key::Inverse(a)) {
            return name.clone();
        }
        let text = format!("1.0 / {}", self.operand(a, WHOLE));
        let name = self.line(&text);
        self.names.insert(Key::Inverse(a), name.clone());
        name
    }

    fn call(&mut self, function: Function, a: Id) -> (String, u8) {
        let text = match function {
            Function::Sin => format!("{}.x", self.sines(a)),
            Function::Cos => format!("{}.y", self.sines(a)),
            Function::Tan => {
                let both = self.sines(a);
                return (format!("{both}.x / {both}.y"), PRODUCT);
            }
            Function::Exp => format!("real_exp({})", self.argument(a)),
            Function::Abs => format!("abs({})", self.argument(a)),
            Function::Atan => format!("arc_tangent({}, 1.0)", self.argument(a)),
            Function::Sqrt | Function::Log | Function::Sinh | Function::Cosh | Function::Tanh | Function::Sign => {
                format!("formula_{}({})", function.name(), self.argument(a))
            }
        };
        (text, WHOLE)
    }

    fn sines(&mut self, a: Id) -> String {
        if let Some(name) = self.names.get(&Key::Sines(a)) {
            return name.clone();
        }
        let text = format!("formula_sin_cos({})", self.argument(a));
        let name = self.line(&text);
        self.names.insert(Key::Sines(a), name.clone());
        name
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text(formulas_of: &[&str]) -> String {
        let parsed: Vec<_> = formulas_of.iter().map(|text| Formula::parse(text).unwrap()).collect();
        formulas(&parsed).text.into_owned()
    }

    #[test]
    fn what_is_common_is_bound_once() {
        let text = text(&["1 + 0.1*exp(-r^2)"]);
        let want = "// ∇n and n = 1 + 0.1 * exp(-r^2)\n\
            fn formula_0(q: Real3) -> Real4 {\n    let square = dot(q, q);\n    let a0 = real_exp(-square);\n";
        assert!(text.starts_with(want), "{text}");
        assert_eq!(text.matches("real_exp").count(), 1, "{text}");
        assert!(!text.contains("switch") && text.contains("return formula_0(q);"), "{text}");
    }

    #[test]
    fn several_are_chosen_by_place() {
        let text = text(&["1 + x^2", "2 - y", "1.5"]);
        for part in [
            "switch place",
            "case 0u",
            "case 1u",
            "return formula_2(q);",
            "Real4(Real(0.0), Real(0.0), Real(0.0), Real(1.5))",
        ] {
            assert!(text.contains(part), "{part}\n{text}");
        }
    }

    #[test]
    fn what_is_deep_is_bound_in_between() {
        // The derivative of a product of many factors has a sum in each product.
        let text = text(&[&format!("2 + x{}", "*y*x".repeat(200))]);
        let depth = |line: &str| line.split('(').count();
        assert!(text.lines().skip(1).all(|line| depth(line) < 3 * DEEPEST), "{text}");
    }

    #[test]
    fn powers_are_squared_up() {
        let text = text(&["1 + x^7"]);
        // The four bound names are x², x³, x⁶ and x⁷.
        assert_eq!(text.matches("let ").count(), 4, "{text}");
    }
}
