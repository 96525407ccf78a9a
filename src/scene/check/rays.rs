//! `[rays]`: how rays are followed.

use super::optics::Optics;
use crate::scene::document::reader::TableReader;
use crate::scene::document::values::{Read, boolean, positive, vector, whole, word};
use crate::scene::document::{Node, Value};
use crate::scene::{
    Accelerate, Accuracy, Bound, Branches, Control, DoublingRule, FlowOrder, Law, Method, Precision, Rays,
    SchwarzschildForm, Segment,
};
use glam::DVec3;

const ACCELERATE: &[(&str, Accelerate)] = &[
    ("auto", Accelerate::Auto),
    ("bvh", Accelerate::Hierarchy),
    ("grid", Accelerate::Grid),
    ("none", Accelerate::None),
];

#[derive(Debug, Clone, Copy, PartialEq)]
enum Name {
    Auto,
    Exact,
    Planar,
    Euler,
    EulerDoubling,
    Leapfrog,
    Rkn4,
    Rk4,
    Rk4Doubling,
    BogackiShampine,
    DormandPrince,
    Snell,
}

const NAMES: &[(&str, Name)] = &[
    ("auto", Name::Auto),
    ("exact", Name::Exact),
    ("planar", Name::Planar),
    ("euler", Name::Euler),
    ("euler-doubling", Name::EulerDoubling),
    ("leapfrog", Name::Leapfrog),
    ("rkn4", Name::Rkn4),
    ("rk4", Name::Rk4),
    ("rk4-doubling", Name::Rk4Doubling),
    ("bogacki-shampine", Name::BogackiShampine),
    ("dormand-prince", Name::DormandPrince),
    ("snell", Name::Snell),
];

const PRECISIONS: &[(&str, Precision)] = &[
    (Precision::Half.name(), Precision::Half),
    (Precision::Single.name(), Precision::Single),
    (Precision::Double.name(), Precision::Double),
];

/// The table itself, which every scene has.
pub fn table<'r, 'a>(root: &TableReader<'r, 'a>) -> Option<TableReader<'r, 'a>> {
    if root.node("rays").is_none() {
        let problem = "the table [rays] is missing";
        let help = "at the least: [rays] with bound = { radius = 50 }";
        root.fault(&[], problem, help);
        return None;
    }
    root.subtable("rays", "rays")
}

/// All but the bound, which was read before. None without it.
pub fn read(table: TableReader, bound: Option<Bound>, optics: &Optics) -> Option<Rays> {
    let law = optics.law;
    let length = table.optional("length", positive);
    let default = default_method(&table, optics, length);
    let name = table.decide("method", default, word(NAMES, &[]));
    if let (Some(name), Some(law)) = (name, law) {
        check_against_law(&table, name, law, optics, length);
    }
    let radius = bound.map_or(1.0, |bound| bound.radius);
    let segment = segment(&table, name, radius);
    let solved = optics.needs_solver(length.is_some());
    let (method, control) = stepping(&table, name.unwrap_or(default), solved);
    let auto = (name == Some(Name::Auto)).then(|| table.or("accuracy", Accuracy::Pixels(0.1), accuracy));
    let auto = auto.filter(|_| method != Method::Exact);
    let max_segments = table.or("max_segments", 1000, whole(1..=1_000_000));
    if name == Some(Name::Planar) {
        check_planar(&table, length, segment);
    }
    let precision = table.or("precision", Precision::Single, word(PRECISIONS, &[]));
    let asymptotic = table.or("asymptotic", false, boolean);
    if let (true, Some(law), Some(bound)) = (asymptotic, law, bound) {
        check_asymptotic(&table, law, bound);
    }
    let branches = table.or("branches", Branches::Enumerated(4), branches);
    let accelerate = table.or("accelerate", Accelerate::Auto, word(ACCELERATE, &[]));
    optics.check(&table, segment, asymptotic, precision);
    table.finish();
    let closed_forms = matches!(name, Some(Name::Auto | Name::Exact | Name::Planar));
    let bound = bound?;
    Some(Rays {
        method,
        control,
        auto,
        segment,
        max_segments,
        bound,
        length,
        asymptotic,
        precision,
        closed_forms,
        leaps: true,
        branches,
        accelerate,
    })
}

/// A depth, or `"random"`.
fn branches(node: &Node) -> Read<Branches> {
    match &node.value {
        Value::Text(_) => word(&[("random", Branches::Random)], &[])(node),
        _ => whole(0..=20)(node).map(Branches::Enumerated),
    }
}

/// Steps along an orbit are cut by angle, and are arcs.
fn check_planar(table: &TableReader, length: Option<f64>, segment: Segment) {
    if length.is_some() {
        let problem = "planar steps are measured by angle and cannot end at a given τ";
        table.fault(&["length"], problem, "use dormand-prince, or leave `length` out");
    }
    if matches!(segment, Segment::Chord { .. }) {
        table.fault(&["segment"], "the planar method has no chords", "use segment = \"arc\", or another method");
    }
}

/// Beyond the bound one centre's orbits go on in closed form, which has to be about the bound's own centre.
fn check_asymptotic(table: &TableReader, law: &Law, bound: Bound) {
    let Some((center, true)) = law.only_center().map(|c| (c, law.is_free_far_away())) else {
        let problem = "`asymptotic` is for a schwarzschild law or one inverse-square source";
        table.fault(&["asymptotic"], problem, "leave it out");
        return;
    };
    if center != bound.center {
        let problem = "`asymptotic` needs the bound's centre at the law's";
        table.fault(&["asymptotic"], problem, format!("set bound.center to {:?}", center.to_array()));
    }
}

/// What chooses steps chooses a method with them; a scene that says nothing leaves both to a calibration.
fn default_method(table: &TableReader, optics: &Optics, length: Option<f64>) -> Name {
    let given = |keys: &[&str]| keys.iter().any(|key| table.gives(key));
    if !optics.bends() {
        Name::Exact
    } else if given(&["step", "scaled_step", "curvature_step", "steps_per_segment"]) {
        Name::Rk4
    } else if given(&["tolerance"]) {
        Name::DormandPrince
    } else if optics.needs_solver(length.is_some()) {
        Name::Auto
    } else {
        Name::Exact
    }
}

/// `"0.1px"`, or radians.
fn accuracy(node: &Node) -> Read<Accuracy> {
    const WHAT: &str = "an angle in radians, or in pixels such as \"0.1px\"";
    match &node.value {
        Value::Text(text) => {
            let pixels = text.strip_suffix("px").and_then(|number| number.trim().parse::<f64>().ok());
            let pixels = pixels.filter(|pixels| pixels.is_finite() && *pixels > 0.0);
            pixels.map(Accuracy::Pixels).ok_or_else(|| node.expected(WHAT))
        }
        _ => positive(node).map(Accuracy::Radians).map_err(|_| node.expected(WHAT)),
    }
}

fn check_against_law(table: &TableReader, name: Name, law: &Law, optics: &Optics, length: Option<f64>) {
    let refuse = |problem: &str| table.fault(&["method"], problem, "use rk4, or leave `method` out");
    match name {
        Name::Exact if optics.needs_solver(length.is_some()) => {
            refuse("the exact method is for straight rays and for media whose paths have a closed form");
        }
        Name::Snell if !optics.has_medium() => {
            refuse("snell needs law.kind = \"medium\", or an interior that bends light");
        }
        Name::Planar if optics.has_solved_interior(length.is_some()) => {
            refuse("planar has no way through these interiors");
        }
        Name::Planar if law.only_center().is_none() => {
            refuse("planar needs a law with a single centre, which keeps a ray in its plane");
        }
        Name::Leapfrog | Name::Rkn4 => match law {
            Law::Flow { order: FlowOrder::Velocity, .. } => {
                refuse("this method is for laws of the second order, and the flow is of the first");
            }
            Law::Schwarzschild { form: SchwarzschildForm::Geodesic, .. } => {
                refuse(
                    "this method is for accelerations that depend on place alone, and the geodesic form's depends on velocity",
                );
            }
            _ => {}
        },
        _ => {}
    }
}

/// The bounding sphere.
pub fn bound(table: &TableReader) -> Option<Bound> {
    const EXAMPLE: &str = "{ center = [0, 0, 0], radius = 50 }";
    let node = table.required_node("bound", EXAMPLE)?;
    let bound = table.reader.open("rays.bound", node)?;
    let center = bound.or("center", DVec3::ZERO, vector);
    let radius = bound.required("radius", "50", positive);
    bound.finish();
    Some(Bound { center, radius: radius? })
}

fn segment(table: &TableReader, name: Option<Name>, radius: f64) -> Segment {
    let arc = Segment::Arc { tolerance: 1e-4 * radius };
    match table.decide("segment", true, word(&[("arc", true), ("chord", false)], &[])) {
        Some(true) => Segment::Arc { tolerance: table.or("arc_tolerance", 1e-4 * radius, positive) },
        Some(false) if name == Some(Name::Exact) => {
            let problem = "the exact method has no chords";
            table.fault(&["segment"], problem, "use segment = \"arc\", or another method");
            arc
        }
        Some(false) => Segment::Chord { steps: table.or("steps_per_segment", 10, whole(1..=1000)) },
        None => arc,
    }
}

fn stepping(table: &TableReader, name: Name, solved: bool) -> (Method, Control) {
    match name {
        Name::Auto if !solved => (Method::Exact, Control::Exact),
        Name::Auto => (Method::Rk4, Control::Scaled { eta: 0.1 }),
        Name::Exact => (Method::Exact, Control::Exact),
        Name::Planar => (Method::Planar, Control::Scaled { eta: table.or("scaled_step", 0.1, positive) }),
        Name::Euler => (Method::Euler, planned(table)),
        Name::EulerDoubling => (Method::Euler, doubling(table)),
        Name::Leapfrog => (Method::Leapfrog, planned(table)),
        Name::Rkn4 => (Method::Rkn4, planned(table)),
        Name::Rk4 => (Method::Rk4, planned(table)),
        Name::Rk4Doubling => (Method::Rk4, doubling(table)),
        Name::BogackiShampine => (Method::BogackiShampine, embedded(table)),
        Name::DormandPrince => (Method::DormandPrince, embedded(table)),
        Name::Snell => {
            let threshold = table.or("threshold", 0.001, positive);
            (Method::Snell { threshold }, planned(table))
        }
    }
}

/// Steps whose size is known before they are taken.
fn planned(table: &TableReader) -> Control {
    let given = table.one_of(&["step", "curvature_step"]);
    let value = given.and_then(|(key, node)| Some((key, table.reader.accept(positive(node))?)));
    let cap = || table.or("scaled_step", 0.5, positive);
    match value {
        Some(("step", step)) => Control::Fixed { step, eta: cap() },
        Some((_, degrees)) => Control::Curvature { turn: degrees.to_radians(), eta: cap() },
        None => Control::Scaled { eta: table.or("scaled_step", 0.1, positive) },
    }
}

fn embedded(table: &TableReader) -> Control {
    let tolerance = table.or("tolerance", 1e-5, positive);
    Control::Embedded { tolerance, eta: table.or("scaled_step", 0.3, positive) }
}

fn doubling(table: &TableReader) -> Control {
    let rules = &[("rejecting", DoublingRule::Rejecting), ("paper", DoublingRule::Paper)];
    let rule = table.or("doubling", DoublingRule::Rejecting, word(rules, &[]));
    let tolerance = table.or("tolerance", 1e-5, positive);
    let grow_below = table.or("grow_below", tolerance / 10.0, positive);
    if grow_below >= tolerance {
        let problem = format!("`grow_below` must be less than the tolerance, {tolerance:e}");
        table.fault(&["grow_below"], problem, "leave it out for a tenth of the tolerance");
    }
    Control::Doubling { rule, tolerance, grow_below, eta: table.or("scaled_step", 0.3, positive) }
}
