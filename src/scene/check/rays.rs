//! `[rays]`: how rays are followed.

use crate::scene::document::reader::TableReader;
use crate::scene::document::values::{positive, vector, whole, word};
use crate::scene::{Bound, Control, DoublingRule, Law, Method, Rays, Segment};
use glam::DVec3;

#[derive(Clone, Copy, PartialEq)]
enum Name {
    Exact,
    Euler,
    EulerDoubling,
    Rk4,
    Rk4Doubling,
    Snell,
}

const NAMES: &[(&str, Name)] = &[
    ("exact", Name::Exact),
    ("euler", Name::Euler),
    ("euler-doubling", Name::EulerDoubling),
    ("rk4", Name::Rk4),
    ("rk4-doubling", Name::Rk4Doubling),
    ("snell", Name::Snell),
];

const LATER: &[&str] = &["leapfrog", "bogacki-shampine", "dormand-prince", "auto"];

/// None if there is no bound.
pub fn read(root: &TableReader, law: Option<&Law>) -> Option<Rays> {
    if root.node("rays").is_none() {
        let problem = "the table [rays] is missing";
        let help = "at the least: [rays] with bound = { radius = 50 }";
        root.fault(&[], problem, help);
        return None;
    }
    let table = root.subtable("rays", "rays")?;
    let default = match law {
        Some(Law::Straight) => Name::Exact,
        _ => Name::Rk4,
    };
    let name = table.decide("method", default, word(NAMES, LATER));
    if let (Some(name), Some(law)) = (name, law) {
        check_against_law(&table, name, law);
    }
    let bound = bound(&table);
    let radius = bound.map_or(1.0, |bound| bound.radius);
    let segment = segment(&table, name, radius);
    let (method, control) = stepping(&table, name.unwrap_or(default));
    let max_segments = table.or("max_segments", 1000, whole(1..=1_000_000));
    let length = table.optional("length", positive);
    table.finish();
    Some(Rays { method, control, segment, max_segments, bound: bound?, length })
}

fn check_against_law(table: &TableReader, name: Name, law: &Law) {
    if name == Name::Exact && *law != Law::Straight {
        let problem = "only straight rays have an exact method here";
        table.fault(&["method"], problem, "use rk4, or leave `method` out");
    }
    if name == Name::Snell && !matches!(law, Law::Medium(_)) {
        let problem = "snell needs law.kind = \"medium\"";
        table.fault(&["method"], problem, "use rk4, or leave `method` out");
    }
}

fn bound(table: &TableReader) -> Option<Bound> {
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

fn stepping(table: &TableReader, name: Name) -> (Method, Control) {
    match name {
        Name::Exact => (Method::Exact, Control::Exact),
        Name::Euler => (Method::Euler, fixed_or_scaled(table)),
        Name::EulerDoubling => (Method::Euler, doubling(table)),
        Name::Rk4 => (Method::Rk4, fixed_or_scaled(table)),
        Name::Rk4Doubling => (Method::Rk4, doubling(table)),
        Name::Snell => {
            let threshold = table.or("threshold", 0.001, positive);
            (Method::Snell { threshold }, fixed_or_scaled(table))
        }
    }
}

fn fixed_or_scaled(table: &TableReader) -> Control {
    let given = table.one_of(&["step", "scaled_step"]);
    let value = given.and_then(|(key, node)| Some((key, table.reader.accept(positive(node))?)));
    match value {
        Some(("step", step)) => Control::Fixed { step },
        Some((_, eta)) => Control::Scaled { eta },
        None => Control::Scaled { eta: 0.1 },
    }
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
