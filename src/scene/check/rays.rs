//! The reader of `[rays]`, which sets the integration of rays.

use glam::DVec3;

use crate::document::reader::TableReader;
use crate::document::values::{
    Parsed, boolean, choice, point, positive, positive_angle, positive_length, text, wavelength, whole, word,
};
use crate::document::{Node, SpannedError, Value};
use crate::model::medium::D_LINE;
use crate::model::method::{self, Demands, NamedMethod};
use crate::model::{Law, control};
use crate::scene::optics::Optics;
use crate::scene::{Accelerate, Accuracy, Auto, Bound, Precision, Rays, Segment, Splitting};

const ACCELERATE: &[(&str, Accelerate)] = &[
    ("auto", Accelerate::Auto),
    ("bvh", Accelerate::Hierarchy),
    ("grid", Accelerate::Grid),
    ("none", Accelerate::None),
];

/// The precisions by name; `None` for the one that a calibration chooses.
const PRECISIONS: &[(&str, Option<Precision>)] = &[
    (Precision::Half.name(), Some(Precision::Half)),
    (Precision::Single.name(), Some(Precision::Single)),
    (Precision::Double.name(), Some(Precision::Double)),
    ("auto", None),
];

/// Returns the table, which every scene must have.
pub fn table<'r, 'a>(root: &TableReader<'r, 'a>) -> Option<TableReader<'r, 'a>> {
    if root.node("rays").is_none() {
        let problem = "missing table [rays]";
        let help = "add [rays] with bounding_sphere = { radius = 50 }";
        root.fault(&[], problem, help);
        return None;
    }
    root.subtable("rays", "rays")
}

/// Reads everything except the bounding sphere, which was read before; returns `None` without it.
pub fn read(table: TableReader, bound: Option<Bound>, optics: &Optics) -> Option<Rays> {
    let length = table.optional("max_parameter", positive);
    let own = optics.law.and_then(|law| law.facts().length);
    let length = length.into_iter().chain(own).reduce(f64::min);
    let segment = segment(&table, optics.arc_tolerance(bound.map_or(1.0, |bound| bound.radius)), is_polygon(&table));
    let demands = optics.demands(length.is_some(), segment.has_chords());
    let (named, auto) = method(&table, optics, demands);
    let (method, control) = match named {
        Some(named) => named.read(&table),
        // The settings until a calibration has run.
        None => (method::PLANNED, control::scaled::with(0.1)),
    };
    let precision = table.or("precision", Some(Precision::Single), word(PRECISIONS));
    if precision.is_none() && !auto {
        let problem = "precision = \"auto\" is chosen together with the method, and this scene specifies a method";
        table.fault(&["precision"], problem, "remove `method` and its settings, or use f32 or f64");
    }
    let accuracy = auto.then(|| table.or("accuracy", Accuracy::Pixels(0.1), accuracy)).filter(|_| named.is_none());
    let auto = accuracy.map(|accuracy| Auto { accuracy, precision: precision.is_none() });
    let precision = precision.unwrap_or(Precision::Single);
    let max_segments = table.or("max_segments", 1000, whole(1..=1_000_000));
    let closed_forms = table.or("closed_forms", named.is_none_or(|named| named.kind.closed_forms), boolean);
    if !closed_forms && optics.bends() && named.is_none_or(|named| named.kind.path == method::Path::Closed) {
        let help = "add method = \"dormand-prince\" and a tolerance, or remove closed_forms";
        table.fault(&["closed_forms"], "closed_forms = false requires a method that integrates paths", help);
    }
    let asymptotic = table.or("sky_at_infinity", false, boolean);
    if let (true, Some(law), Some(bound)) = (asymptotic, optics.law, bound) {
        check_asymptotic(&table, law, bound);
    }
    let branches = branching(&table, optics);
    let wavelength = table.or("wavelength", D_LINE, wavelength);
    if table.gives("wavelength") && !optics.disperses() {
        let help = "remove it, or give an interior kind = \"sellmeier\"";
        table.fault(&["wavelength"], "`wavelength` has no effect, because nothing in the scene is dispersive", help);
    } else if let Some(problem) = optics.refuses_wavelength(wavelength) {
        let help = "use a wavelength in that range, in nm, or a glass with another formula";
        table.fault(&["wavelength"], problem, help);
    }
    let accelerate = table.or("acceleration", Accelerate::Auto, word(ACCELERATE));
    optics.check(&table, segment, asymptotic, precision);
    table.finish();
    Some(Rays {
        method,
        control,
        auto,
        segment,
        max_segments,
        bounding_sphere: bound?,
        max_parameter: length,
        sky_at_infinity: asymptotic,
        precision,
        closed_forms,
        leaps: true,
        max_splits: branches,
        acceleration: accelerate,
        // Without objects, both kinds of lighting are equal.
        path_tracing: optics.paths.filter(|_| !optics.objects.is_empty()),
        wavelength,
    })
}

/// Reads the rays that continue after a split; path tracing follows one of the two.
fn branching(table: &TableReader, optics: &Optics) -> Splitting {
    let usual = if optics.paths.is_some() { Splitting::Random } else { Splitting::Enumerated(4) };
    let wanted = table.or("max_splits", usual, branches);
    if optics.paths.is_some() && wanted != Splitting::Random {
        let problem = "path tracing follows one branch, drawn at random, at each surface";
        table.fault(&["max_splits"], problem, "remove it, or use \"stochastic\"");
    }
    wanted
}

/// Returns the method that the scene specifies or that its other keys imply, or `None` if a calibration chooses it or closed forms suffice;
/// and `true` if the choice is `auto`.
fn method(table: &TableReader, optics: &Optics, demands: Demands) -> (Option<NamedMethod>, bool) {
    let names = method::names();
    let words: Vec<&str> = std::iter::once("auto").chain(names.iter().map(|(name, _)| name.as_str())).collect();
    let Some(chosen) = table.decide("method", None, |node| choice(&words)(node).map(Some)) else {
        // The error is reported, and all keys of methods are accepted.
        return (Some(NamedMethod::plain(default_method(table, optics, demands).unwrap_or(method::PLANNED))), false);
    };
    let named = match chosen {
        Some(0) => None,
        Some(k) => Some(names[k - 1].1),
        None => default_method(table, optics, demands).map(NamedMethod::plain),
    };
    match named {
        Some(named) => {
            let refused = if optics.law.is_some() { (named.kind.refuses)(&demands) } else { Vec::new() };
            for refusal in refused {
                table.fault(&[refusal.key], refusal.problem, refusal.help);
            }
            (Some(named), false)
        }
        None if demands.needs_solver => (None, true),
        None => (Some(NamedMethod::plain(method::CLOSED_FORMS)), true),
    }
}

/// Reads a number of splits, or `"stochastic"`.
fn branches(node: &Node) -> Parsed<Splitting> {
    match &node.value {
        Value::Text(_) => word(&[("stochastic", Splitting::Random)])(node),
        _ => whole(0..=20)(node).map(Splitting::Enumerated),
    }
}

/// Checks that the law has one center, at the center of the bounding sphere: beyond it, orbits continue in closed form.
fn check_asymptotic(table: &TableReader, law: &dyn Law, bound: Bound) {
    let Some(center) = law.facts().orbit.filter(|orbit| orbit.is_free_far_away).map(|orbit| orbit.center) else {
        let problem = "`sky_at_infinity` requires the law of a black hole or one inverse-square source";
        table.fault(&["sky_at_infinity"], problem, "remove it");
        return;
    };
    if center != bound.center {
        let problem = "`sky_at_infinity` requires a bounding sphere with the center of the law";
        table.fault(&["sky_at_infinity"], problem, format!("set bounding_sphere.center to {:?}", center.to_array()));
    }
}

/// Returns the default method for the step-size keys; without such keys a calibration chooses both.
fn default_method(table: &TableReader, optics: &Optics, demands: Demands) -> Option<method::Method> {
    let given = |keys: &[&str]| keys.iter().any(|key| table.gives(key));
    if !optics.bends() {
        Some(method::CLOSED_FORMS)
    } else if given(&["step", "scaled_step", "curvature_step", "steps_per_segment"]) {
        Some(method::PLANNED)
    } else if given(&["tolerance"]) {
        Some(method::TOLERANT)
    } else if demands.needs_solver {
        None
    } else {
        Some(method::CLOSED_FORMS)
    }
}

/// Reads an accuracy such as `"0.1px"`, or in radians.
fn accuracy(node: &Node) -> Parsed<Accuracy> {
    const WHAT: &str = "an angle in radians, or in pixels such as \"0.1px\"";
    match &node.value {
        Value::Text(text) => {
            let pixels = text.strip_suffix("px").and_then(|number| number.trim().parse::<f64>().ok());
            let pixels = pixels.filter(|pixels| pixels.is_finite() && *pixels > 0.0);
            pixels.map(Accuracy::Pixels).ok_or_else(|| node.expected(WHAT))
        }
        Value::Quantity(_) => positive_angle(node).map(|degrees| Accuracy::Radians(degrees.to_radians())),
        _ => positive(node).map(Accuracy::Radians).map_err(|_| node.expected(WHAT)),
    }
}

/// Reads the bounding sphere.
pub fn bound(table: &TableReader) -> Option<Bound> {
    const EXAMPLE: &str = "{ center = [0, 0, 0], radius = 50 }";
    let node = table.required_node("bounding_sphere", EXAMPLE)?;
    if !matches!(node.value, Value::Table(_)) {
        // A plain number is the radius.
        let radius = positive_length(node).unwrap_or(50.0);
        let help = format!("for example bounding_sphere = {{ radius = {radius} }}");
        table.reader.fault(SpannedError { help, ..node.expected("a table") });
        return None;
    }
    let bound = table.reader.open("rays.bounding_sphere", node)?;
    let center = bound.or("center", DVec3::ZERO, point);
    let radius = bound.required("radius", "50", positive_length);
    bound.finish();
    Some(Bound { center, radius: radius? })
}

/// Returns `true` if the scene specifies a method with straight steps.
fn is_polygon(table: &TableReader) -> bool {
    let written = table.node("method").and_then(|node| text(node).ok());
    method::names().iter().any(|(name, named)| Some(&**name) == written && named.kind.polygon)
}

fn segment(table: &TableReader, tolerance: f64, polygon: bool) -> Segment {
    let arc = Segment::Arc { tolerance };
    match table.decide("segment", !polygon, word(&[("arc", true), ("chord", false)])) {
        Some(true) => Segment::Arc { tolerance: table.or("arc_tolerance", tolerance, positive_length) },
        Some(false) => {
            Segment::Chord { steps: table.or("steps_per_segment", if polygon { 1 } else { 10 }, whole(1..=1000)) }
        }
        None => arc,
    }
}
