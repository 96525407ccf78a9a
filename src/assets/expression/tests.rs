//! Tests of parsing and printing, values and gradients: the graph is compared with the tree's value, computed directly.

#![allow(clippy::float_cmp, reason = "constants are folded exactly")]

use super::parse;
use super::tree::{Extremum, Name, Operator, Tree};
use super::{Formula, FormulaError, Function, Node, PLACE, Variable};
use glam::DVec3;
use proptest::prelude::*;

const X: Name = Name::Variable("x", Variable::PLACE[0]);
const Y: Name = Name::Variable("y", Variable::PLACE[1]);
const Z: Name = Name::Variable("z", Variable::PLACE[2]);

fn parse(text: &str) -> Result<Tree, FormulaError> {
    parse::parse(text, &PLACE)
}

fn formula(text: &str) -> Formula {
    Formula::parse(text).unwrap_or_else(|error| panic!("{text}: {error:?}"))
}

/// Returns the value of a tree by direct arithmetic, without a graph.
fn value(tree: &Tree, q: DVec3) -> f64 {
    let of = |tree: &Tree| value(tree, q);
    match tree {
        Tree::Number(value) => *value,
        Tree::Name(X) => q.x,
        Tree::Name(Y) => q.y,
        Tree::Name(Z) => q.z,
        Tree::Name(Name::R) => (q.x * q.x + q.y * q.y + q.z * q.z).sqrt(),
        Tree::Name(Name::Pi) => std::f64::consts::PI,
        Tree::Name(Name::Variable(name, _)) => unreachable!("{name}"),
        Tree::Term(name, _) => unreachable!("{name}"),
        Tree::Negative(a) => -of(a),
        Tree::Binary(Operator::Plus, a, b) => of(a) + of(b),
        Tree::Binary(Operator::Minus, a, b) => of(a) - of(b),
        Tree::Binary(Operator::Times, a, b) => of(a) * of(b),
        Tree::Binary(Operator::Over, a, b) => of(a) / of(b),
        Tree::Binary(Operator::Power, a, b) => of(a).powf(of(b)),
        Tree::Call(function, a) => function.of(of(a)),
        // NaN operands give NaN.
        Tree::Extremum(Extremum::Min, a, b) => {
            if of(a) < of(b) {
                of(a)
            } else {
                of(b) + 0.0 * of(a)
            }
        }
        Tree::Extremum(Extremum::Max, a, b) => {
            if of(a) > of(b) {
                of(a)
            } else {
                of(b) + 0.0 * of(a)
            }
        }
    }
}

#[test]
fn operators_bind_as_in_mathematics() {
    for (text, same) in [
        ("1 + 2 * x", "1 + (2 * x)"),
        ("1 - x - y", "(1 - x) - y"),
        ("1 / x / y * z", "((1 / x) / y) * z"),
        ("-x^2", "-(x^2)"),
        ("2^-x", "2^(-x)"),
        ("x^y^z", "x^(y^z)"),
        ("-x * y", "(-x) * y"),
        ("1 - -x", "1 - (-x)"),
        ("x*-y", "x * (-y)"),
        ("  min( x ,1)/2. ", "min(x, 1) / 2"),
        (".5e1", "5"),
    ] {
        assert_eq!(parse(text), parse(same), "{text}");
    }
    let at = DVec3::new(2.0, 3.0, 5.0);
    for (text, want) in [
        ("2 - 3 - 4", -5.0),
        ("2^3^2", 512.0),
        ("-x^2", -4.0),
        ("12 / x / 3", 2.0),
        ("2^-1", 0.5),
        ("max(x, y) * min(x, y) + abs(-z)", 11.0),
        ("r^2", 38.0),
        ("2 * pi", std::f64::consts::TAU),
        ("sqrt(x + 2) + 1e1", 12.0),
        ("4^0.5 + 4^1.5 + x^-1", 10.5),
    ] {
        assert_eq!(formula(text).value(at), want, "{text}");
    }
}

/// The location of the error in the text is marked by «».
#[test]
fn mistakes_have_their_place() {
    for (marked, problem, help) in [
        ("«»", "the formula is empty", "for example"),
        ("«   »", "the formula is empty", ""),
        ("1 + «»", "the formula is incomplete", "expected a number"),
        ("2«(»x)", "expected an operator before this", "2 * x"),
        ("2«x»", "expected an operator before this", "2 * x"),
        ("1 + «*» 2", "expected a number, a name or (, found `*`", ""),
        ("«(»1 + x", "unmatched `(`", ""),
        ("exp«(»-r^2", "unmatched `(`", ""),
        ("1 + x«)»", "unmatched `)`", ""),
        ("1 + «xx»", "unknown name `xx`", "use `x`"),
        ("«ln»(x)", "unknown name `ln`", "use log, the natural logarithm"),
        ("«sine»(x)", "unknown name `sine`", "use `sin"),
        ("«exp» + 1", "`exp` is a function", "exp(x)"),
        ("«min» + 1", "`min` is a function", "min(1, x)"),
        ("«min»(x)", "`min` requires two arguments", "min(1, x)"),
        ("exp(x«,» y)", "unexpected `,`", "only min and max"),
        ("min(x, y«,» z)", "unexpected `,`", "only min and max"),
        ("1 «,» 2", "unexpected `,`", ""),
        ("2 * «x»(y)", "`x` is not a function", "x * (..)"),
        ("x «**» 2", "unknown operator `**`", "^"),
        ("1 «−» x", "unexpected character `−`", "write minus as -"),
        ("r«²»", "unexpected character `²`", "such as r^2"),
        ("é + «§»", "unexpected character `§`", ""),
        ("1 + «.»", "expected a number, found `.`", ""),
        ("1 + «1.2.3»", "expected an operator before this", ""),
        ("«1e31» * x", "outside the range of 32-bit floats", "1e-30"),
        ("«1e-40» * x", "outside the range of 32-bit floats", "1e-30"),
        ("«1 / 0»", "a constant part of the formula has no finite value", ""),
        ("«x + sqrt(-1)»", "a constant part of the formula has no finite value", ""),
        ("«1e30 * 1e30 * x»", "outside the range of 32-bit floats", ""),
    ] {
        // If one number follows another, the error is at the second.
        let marked = marked.replace("«1.2.3»", "1.2«.3»");
        let start = marked.find('«').unwrap();
        let end = marked.find('»').unwrap() - '«'.len_utf8();
        let text = marked.replace(['«', '»'], "");
        let FormulaError { place, problem: said, help: helped } = Formula::parse(&text).expect_err(&text);
        let unknown = marked.starts_with("é +");
        if !unknown {
            assert_eq!((&place, &said.contains(problem)), (&(start..end), &true), "{text}: {said}");
        }
        assert!(helped.contains(help) || unknown, "{text}: {helped}");
    }
    let tower = format!("{}x{}", "(".repeat(30), "^64)".repeat(30));
    assert!(Formula::parse(&format!("{tower} * {tower}")).unwrap_err().problem.contains("outside the range"));
    assert!(Formula::parse(&"(".repeat(900)).unwrap_err().problem.contains("more than 100 levels"));
    assert!(Formula::parse(&"-".repeat(900)).unwrap_err().problem.contains("more than 100 levels"));
    assert!(Formula::parse(&"2^".repeat(400)).unwrap_err().problem.contains("more than 100 levels"));
    assert!(Formula::parse(&"x + ".repeat(400)).unwrap_err().problem.contains("longer than 1000"));
}

#[test]
fn gradients_are_simple() {
    // The gradient of a Gaussian has a single e^(−r²), a constant in front, and no division.
    let gaussian = formula("1 + 0.1 * exp(-r^2)");
    let (graph, roots) = gaussian.graph();
    let reached = graph.reached(&roots);
    let count = |wanted: fn(Node) -> bool| reached.iter().filter(|id| wanted(graph.node(**id))).count();
    assert_eq!(count(|node| matches!(node, Node::Call(..))), 1);
    assert_eq!(count(|node| matches!(node, Node::Distance | Node::Direction(_) | Node::Quotient(..))), 0);
    assert_eq!(gaussian.gradient(DVec3::ZERO), DVec3::ZERO);
    // A constant has no gradient.
    assert_eq!(formula("2 * pi / 4").constant(), Some(std::f64::consts::FRAC_PI_2));
    assert_eq!(formula("x^0 + 0 * y").constant(), Some(1.0));
    // Odd functions of r also have a gradient at the center: 0, between the directions.
    for text in ["r", "sin(r)", "r^3 + r", "exp(-r)", "cos(r)"] {
        assert_eq!(formula(text).gradient(DVec3::ZERO), DVec3::ZERO, "{text}");
    }
    assert_eq!(
        formula("abs(x) + max(y, 2) - min(z, 2)").gradient(DVec3::new(-1.0, 3.0, 1.0)),
        DVec3::new(-1.0, 1.0, -1.0)
    );
}

/// Each function is tested where it is steep and curved; the central difference itself has an error of h² f‴/6, some 1e-9.
#[test]
fn every_function_has_its_derivative() {
    for (name, _) in Function::WRITTEN {
        for inner in ["x + 0.3 * y * z", "0.5 * r", "(1 + x^2) / (2 + y)"] {
            let f = formula(&format!("{name}({inner})"));
            for q in [DVec3::new(0.7, 0.2, -0.4), DVec3::new(1.3, -0.9, 0.1)] {
                assert_gradient(&f, q, 1e-7);
            }
        }
    }
}

fn difference(f: &Formula, q: DVec3, h: f64) -> DVec3 {
    DVec3::from_array(DVec3::AXES.map(|e| (f.value(q + h * e) - f.value(q - h * e)) / (2.0 * h)))
}

fn assert_gradient(f: &Formula, q: DVec3, tolerance: f64) {
    let (got, want) = (f.gradient(q), difference(f, q, 1e-5));
    assert!(got.distance(want) <= tolerance * (1.0 + want.length()), "{f} at {q}: {got}, not {want}");
}

fn trees() -> impl Strategy<Value = Tree> {
    let leaf = prop_oneof![
        (0..40_u8).prop_map(|n| Tree::Number(f64::from(n) / 8.0)),
        prop::sample::select(PLACE.names.to_vec()).prop_map(Tree::Name),
    ];
    leaf.prop_recursive(5, 24, 2, |inner| {
        let operators = vec![Operator::Plus, Operator::Minus, Operator::Times, Operator::Over];
        let functions = Function::WRITTEN.map(|(_, function)| function).to_vec();
        let exponents = [-3.0, -1.0, -0.5, 0.0, 0.5, 1.0, 1.25, 1.5, 2.0, 3.0, 4.0].to_vec();
        prop_oneof![
            4 => (prop::sample::select(operators), inner.clone(), inner.clone())
                .prop_map(|(o, a, b)| Tree::Binary(o, Box::new(a), Box::new(b))),
            1 => inner.clone().prop_map(|a| Tree::Negative(Box::new(a))),
            2 => (prop::sample::select(functions), inner.clone()).prop_map(|(f, a)| Tree::Call(f, Box::new(a))),
            2 => (inner.clone(), prop::sample::select(exponents)).prop_map(|(a, k): (Tree, f64)| {
                let size = Tree::Number(k.abs());
                let k = if k < 0.0 { Tree::Negative(Box::new(size)) } else { size };
                Tree::Binary(Operator::Power, Box::new(a), Box::new(k))
            }),
            1 => (any::<bool>(), inner.clone(), inner).prop_map(|(min, a, b)| {
                Tree::Extremum(if min { Extremum::Min } else { Extremum::Max }, Box::new(a), Box::new(b))
            }),
        ]
    })
}

fn places() -> impl Strategy<Value = DVec3> {
    prop::array::uniform3(-2.0..2.0_f64).prop_map(DVec3::from_array)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, ..ProptestConfig::default() })]

    #[test]
    fn printing_and_reading_gives_the_same_tree(tree in trees()) {
        let text = tree.to_string();
        prop_assert_eq!(parse(&text), Ok(tree), "{}", text);
    }

    #[test]
    fn any_text_is_read_or_refused(text in "[-+*/^(), .0-9xyzrpiexpminlogé]{0,60}") {
        if let Err(error) = Formula::parse(&text) {
            prop_assert!(text.get(error.place).is_some() && !error.problem.is_empty());
        }
    }

    /// The graph has the value of the tree wherever the value exists, and neither the value nor the slope is extreme.
    #[test]
    fn the_graph_has_the_value_of_the_tree(tree in trees(), q in places()) {
        let want = value(&tree, q);
        if let Ok(f) = Formula::parse(&tree.to_string()) && want.is_finite() && want.abs() < 1e3 {
            // Near a pole rounding errors grow: the tolerance is the effect of a change of the input by some rounding errors.
            let moved = value(&tree, q * (1.0 + 1e-13));
            let slack = 1e-9 * (1.0 + want.abs()) + 1e2 * (moved - want).abs();
            let got = f.value(q);
            prop_assert!((got - want).abs() <= slack || slack.is_nan(), "{} at {}: {}, not {}", f, q, got, want);
        }
    }

    /// Two differences that agree give the slope; if they do not, there is a kink, a pole or a rapid change.
    #[test]
    fn the_gradient_is_the_central_difference(tree in trees(), q in places()) {
        if let Ok(f) = Formula::parse(&tree.to_string()) {
            let (coarse, fine) = (difference(&f, q, 2e-5), difference(&f, q, 1e-5));
            let size = f.value(q).abs() + fine.length();
            if size < 1e4 && coarse.distance(fine) <= 1e-7 * (1.0 + size) && !has_kink_near(&f, q) {
                let got = f.gradient(q);
                prop_assert!(got.distance(fine) <= 1e-5 * (1.0 + size), "{} at {}: {}, not {}", f, q, got, fine);
            }
        }
    }
}

/// Returns `true` if the gradient changes abruptly within the reach of the differences.
fn has_kink_near(f: &Formula, q: DVec3) -> bool {
    let here = f.gradient(q);
    DVec3::AXES.iter().flat_map(|e| [q + 3e-5 * *e, q - 3e-5 * *e]).any(|p| {
        let there = f.gradient(p);
        let off = there.distance(here);
        off.is_nan() || off > 1e-3 * (1.0 + here.length())
    })
}

/// Functions of t with every function and every operator.
fn of_t(text: &str) -> super::Curve {
    super::Curve::parse([text, "t", "0"]).unwrap_or_else(|error| panic!("{text}: {error:?}"))
}

const OF_T: [&str; 14] = [
    "t^3 - 2*t^2 + 1",
    "sin(3*t)*cos(t)",
    "exp(-t^2)/(1 + t^2)",
    "sqrt(t^2 + 1) - abs(t - 1)",
    "min(t, 2 - t)*max(t, sin(t))",
    "tan(0.4*t)",
    "log(2 + cos(t))",
    "sinh(t) - cosh(2*t) + tanh(t/3)",
    "atan(5*t)/t",
    "t^-2",
    "2^t",
    "-(t - 0.5)^4",
    "abs(abs(t) - 1)^3",
    "(t^2 + t)*(t^2 + t)",
];

proptest! {
    /// The values of a formula and its derivatives at any t of an interval are in their intervals.
    #[test]
    fn intervals_hold_all_values(which in 0..OF_T.len(), a in -3.0_f64..3.0, size in 0.0_f64..2.0, part in 0.0_f64..1.0) {
        let curve = of_t(OF_T[which]);
        let (all, _) = curve.over(super::Interval::between(a, a + size));
        let at = curve.at(a + part * size);
        for order in 0..at.len() {
            let (own, value) = (all[order][0], at[order].x);
            let rounding = 1e-12 * (1.0 + own.lo.abs().min(own.hi.abs()));
            let holds = own.lo - rounding <= value && value <= own.hi + rounding;
            prop_assert!(holds || !value.is_finite(), "{} at {order}: {value} and {own:?}", OF_T[which]);
        }
    }

    /// The intervals converge to the value.
    #[test]
    fn small_intervals_are_close(which in 0..OF_T.len(), a in 0.3_f64..0.9) {
        let curve = of_t(OF_T[which]);
        let (all, _) = curve.over(super::Interval::between(a, a + 1e-6));
        prop_assert!(all[0][0].hi - all[0][0].lo < 2e-4, "{}: {:?}", OF_T[which], all[0][0]);
    }
}

/// The derivatives by t are compared with differences.
#[test]
fn curves_have_their_derivatives() {
    for text in OF_T {
        let curve = of_t(text);
        for t in [0.37, 0.81, 1.43] {
            let h = 1e-5;
            let (before, here, after) = (curve.at(t - h), curve.at(t), curve.at(t + h));
            for order in 0..4 {
                let slope = (after[order].x - before[order].x) / (2.0 * h);
                let wanted = here[order + 1].x;
                assert!(
                    (slope - wanted).abs() < 1e-6 * (1.0 + wanted.abs() + here[order].x.abs() / h * 1e-4),
                    "{text}, {order}: {slope} {wanted}"
                );
            }
        }
    }
}
