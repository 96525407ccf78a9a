//! The reader of `[[volumes]]`.

use std::ops::Range;

use glam::DVec3;

use super::radiation::{self, Radiation};
use super::{Flow, Volume, VolumeRegion, grids};
use crate::assets::{Files, Transform, VolumeField, VolumeFormulas, VolumeTexts};
use crate::document::reader::TableReader;
use crate::document::values::{angles, choice, extents, number, point, positive, text, word};
use crate::document::{KeyReference, Node, SpannedError, Value, key_rows};
use crate::model::Law;
use crate::model::law::Observer;
use crate::model::shape;

/// The default temperature of luminance 1, in kelvins.
const WHITE: f64 = 6500.0;
/// The largest number of volumes.
const MOST: usize = 16;

/// Returns the reference rows.
pub(crate) fn reference() -> Vec<KeyReference> {
    let own = key_rows! {
        "volumes" {
            shape: "sphere | box | cylinder" = "all of space", "region that contains the matter, placed like an object";
            translate if "shape": "[x, y, z]" = "[0, 0, 0]", "translation, after scale and rotate";
            rotate if "shape": "[x, y, z]" = "[0, 0, 0]", "rotation about x, then y, then z, in degrees";
            scale if "shape": "number above 0, or [x, y, z]" = "1", "scale factor";
            density: "number or formula" = "1", "density n: a formula of x, y, z, r, rho, theta, phi and t";
            emission if "no source": "number, formula, or three" = "0",
                "emission per unit length: a formula of position, n and, with [radiation], nu; without it also three, one per color channel; numbers are multiplied by n";
            absorption: "number, formula, or three" = "0", "absorption coefficient, per unit length, likewise";
            source if "no emission": "table" = "none", "temperature in kelvins of matter that emits as a black body: emission is absorption times the Planck function";
            flow: "static | eulerian | zamo | prograde-orbit | retrograde-orbit | infalling | table" = "static",
                "motion of the matter, as an observer at each position, or a table with one of the keys below";
            parameters: "table of numbers" = "{}", "names for numbers in the formulas";
            grids: "table of tables" = "{}", "names for samples on grids in the formulas, at most 8, each a table with the keys below: trilinear between the samples, and 0 outside";
            terms: "table of formulas" = "{}", "names for formulas of position, each of which may use the ones before it";
        }
        "volumes.flow" {
            angular_momentum: "number or formula" = "none", "l = -u_phi/u_t about the axis of the law";
            angular_velocity: "number or formula" = "none", "dphi/dt about the axis of the law";
            velocity: "three numbers or formulas" = "none",
                "velocity relative to the eulerian observer, as a fraction of the speed of light";
        }
        "volumes.source" {
            black_body: "number or formula" = "required", "temperature, in kelvins";
            white: "number above 0" = "6500", "temperature in kelvins of the black body that has luminance 1 in color, without [radiation]";
        }
    };
    let shapes = shape::KINDS.reference().into_iter().filter(|row| {
        ["axis", "center", "height", "max", "min", "radius", "size"].contains(&row.key)
            && SHAPES.iter().any(|name| row.when.contains(&format!("\"{name}\"")))
    });
    let placed = shapes.map(|row| KeyReference { table: "volumes", ..row });
    own.iter()
        .take(1)
        .cloned()
        .chain(placed)
        .chain(own.iter().skip(1).cloned())
        .chain(grids::reference())
        .chain(radiation::reference())
        .collect()
}

/// The shapes that have a norm in WGSL.
const SHAPES: [&str; 3] = ["sphere", "box", "cylinder"];

/// Reads `[radiation]` and all volumes without errors.
pub(crate) fn read(root: &TableReader, law: Option<&dyn Law>, files: &mut Files) -> (Vec<Volume>, Option<Radiation>) {
    let radiation = radiation::read(root);
    let tables = root.subtables("volumes", "volumes");
    if tables.len() > MOST {
        root.fault(&["volumes"], format!("{} volumes exceed the limit of {MOST}", tables.len()), "merge some of them");
        return (Vec::new(), None);
    }
    if tables.is_empty() && root.gives("radiation") {
        root.fault(&["radiation"], "`radiation` requires matter that emits light", "add [[volumes]]");
    }
    let with_frequencies = root.gives("radiation");
    let all = tables.into_iter().filter_map(|table| {
        let volume = volume(&table, law, with_frequencies, files);
        table.finish();
        volume
    });
    (all.collect(), radiation)
}

fn volume(table: &TableReader, law: Option<&dyn Law>, with_frequencies: bool, files: &mut Files) -> Option<Volume> {
    let region = if table.gives("shape") { Some(region(table, files)?) } else { None };
    let parameters = table.named("parameters", "volumes.parameters", &|node| table.reader.accept(number(node)));
    let grids = grids::read(table, files);
    let terms = table.named("terms", "volumes.terms", &|node| formula(table, node));
    let density = table.node("density");
    let (emission, source) = (table.node("emission"), table.subtable("source", "volumes.source"));
    if let (Some(node), true) = (emission, source.is_some()) {
        table.reader.fault(node.fault("`emission` cannot be combined with `source`", "remove one of them"));
    }
    let mut white = WHITE;
    let temperature = source.and_then(|source| {
        let node = source.required_node("black_body", "\"1e7\"");
        white = source.or("white", WHITE, positive);
        if with_frequencies && source.gives("white") {
            source.fault(&["white"], "`white` applies to colors, and cannot be combined with [radiation]", "remove it");
        }
        source.finish();
        node
    });
    let absorption = table.node("absorption");
    let (flow, flows) = flow(table, law)?;
    let most = if with_frequencies { 1 } else { 3 };
    let each = |nodes: &[&Node]| nodes.iter().map(|node| formula(table, node)).collect::<Option<Vec<_>>>();
    let optional = |node: Option<&Node>| match node {
        Some(node) => formula(table, node).map(Some),
        None => Some(None),
    };
    let (parameters, grids, terms) = (parameters?, grids?, terms?);
    let (emission_nodes, absorption_nodes) = (parts(table, emission, most)?, parts(table, absorption, most)?);
    let texts = VolumeTexts {
        parameters: parameters.iter().map(|(name, _, value)| (name.clone(), *value)).collect(),
        grids: grids.iter().map(|(name, ..)| name.clone()).collect(),
        terms: terms.iter().map(|(name, _, value)| (name.clone(), value.clone())).collect(),
        density: optional(density)?.unwrap_or_else(|| "1".to_owned()),
        emission: coefficients(table, &emission_nodes)?,
        absorption: coefficients(table, &absorption_nodes)?,
        temperature: optional(temperature)?,
        flow: each(&flows)?,
    };
    let node_of = |field: VolumeField| match field {
        VolumeField::Parameter(k) => Some(parameters[k].1),
        VolumeField::GridName(k) => Some(grids[k].1),
        VolumeField::Term(k) | VolumeField::TermName(k) => Some(terms[k].1),
        VolumeField::Density => density,
        VolumeField::Emission(k) => emission_nodes.get(k).copied(),
        VolumeField::Absorption(k) => absorption_nodes.get(k).copied(),
        VolumeField::Temperature => temperature,
        VolumeField::Flow(k) => flows.get(k).copied(),
    };
    let fault = |field: VolumeField, place: Range<usize>, problem: String, help: String| match node_of(field) {
        Some(node)
            if matches!(node.value, Value::Text(_))
                && !matches!(field, VolumeField::TermName(_) | VolumeField::GridName(_)) =>
        {
            table.reader.fault_inside(node, place, problem, help);
        }
        Some(node) => table.reader.fault(node.fault(problem, help)),
        None => table.fault(&[], problem, help),
    };
    let formulas = VolumeFormulas::parse(texts)
        .map_err(|(field, error)| fault(field, error.place, error.problem, error.help))
        .ok()?;
    if let Some(field) = formulas.with_frequency().filter(|_| !with_frequencies) {
        let length = node_of(field).map_or(0, |node| text(node).map_or(0, str::len));
        let help = "add [radiation] with frequencies, or remove nu".to_owned();
        fault(field, 0..length, "`nu` requires the frequencies of light".to_owned(), help);
        return None;
    }
    let grids = grids.into_iter().map(|(_, _, grid)| grid).collect();
    Some(Volume { region, formulas, flow, white, grids })
}

fn region(table: &TableReader, files: &mut Files) -> Option<VolumeRegion> {
    let chosen = table.decide_required("shape", "\"sphere\"", choice(&SHAPES))?;
    let read = shape::KINDS.chosen(table)?;
    let (shape, own) = read(table, 1.0, files)?;
    let translate = table.or("translate", DVec3::ZERO, point);
    let rotate = table.or("rotate", DVec3::ZERO, angles);
    let scale = table.or("scale", DVec3::ONE, |node| match node.value {
        Value::Array(_) => extents(node),
        _ => positive(node).map(DVec3::splat),
    });
    let transform = Transform(Transform::new(scale, rotate, translate).0 * own);
    Some(VolumeRegion { shape, transform, name: SHAPES[chosen] })
}

/// Returns the nodes of one coefficient, or of three.
fn parts<'a>(table: &TableReader, node: Option<&'a Node>, most: usize) -> Option<Vec<&'a Node>> {
    let Some(node) = node else { return Some(Vec::new()) };
    match &node.value {
        Value::Array(items) if items.len() == 3 && most == 3 => Some(items.iter().collect()),
        Value::Array(_) if most == 1 => {
            let help = "write one formula, which may depend on nu";
            table.reader.fault(node.fault("with [radiation], coefficients have no color channels", help));
            None
        }
        Value::Array(_) => {
            table.reader.fault(node.expected("one number or formula, or three"));
            None
        }
        _ => Some(vec![node]),
    }
}

/// Returns the formulas of a coefficient; numbers are multiplied by the density.
fn coefficients(table: &TableReader, nodes: &[&Node]) -> Option<Vec<String>> {
    let one = |node: &&Node| {
        if matches!(node.value, Value::Text(_)) {
            return formula(table, node);
        }
        let value = table.reader.accept(number(node))?;
        if value < 0.0 {
            table.reader.fault(node.fault(format!("expected a coefficient of 0 or above, found {value}"), ""));
            return None;
        }
        Some(format!("{value:?}*n"))
    };
    let all: Option<Vec<String>> = nodes.iter().map(one).collect();
    all.map(|all| if all.is_empty() { vec!["0".to_owned()] } else { all })
}

/// Returns a number or a formula as text.
fn formula(table: &TableReader, node: &Node) -> Option<String> {
    match &node.value {
        Value::Text(text) => Some(text.clone()),
        Value::Integer(_) | Value::Float(_) => {
            let value = table.reader.accept(number(node))?;
            Some(if value < 0.0 { format!("(-{:?})", -value) } else { format!("{value:?}") })
        }
        _ => {
            table.reader.fault(node.expected("a number, or a formula in quotes"));
            None
        }
    }
}

/// The names of the flows that are observers.
const FLOWS: [(&str, Observer); 6] = [
    ("static", Observer::Static),
    ("eulerian", Observer::Eulerian),
    ("zamo", Observer::Zamo),
    ("prograde-orbit", Observer::ProgradeOrbit),
    ("retrograde-orbit", Observer::RetrogradeOrbit),
    ("infalling", Observer::Infalling),
];

/// Reads the motion, and returns the nodes of its formulas.
fn flow<'a>(table: &TableReader<'_, 'a>, law: Option<&dyn Law>) -> Option<(Flow, Vec<&'a Node>)> {
    let Some(node) = table.node("flow") else { return Some((Flow::Observer(Observer::Static), Vec::new())) };
    let (flow, nodes) = if let Value::Table(_) = node.value {
        let own = table.reader.open("volumes.flow", node)?;
        let keys = ["angular_momentum", "angular_velocity", "velocity"];
        let (key, inner) = own.required_one_of(&keys, "one of angular_momentum, angular_velocity, velocity")?;
        own.finish();
        match (key, &inner.value) {
            ("angular_momentum", _) => (Flow::AngularMomentum, vec![inner]),
            ("angular_velocity", _) => (Flow::AngularVelocity, vec![inner]),
            (_, Value::Array(items)) if items.len() == 3 => (Flow::Velocity, items.iter().collect()),
            _ => {
                table.reader.fault(inner.expected("three numbers or formulas"));
                return None;
            }
        }
    } else {
        (Flow::Observer(table.reader.accept(word(&FLOWS)(node))?), Vec::new())
    };
    let law = law?;
    let facts = law.facts();
    let is_still = flow == Flow::Observer(Observer::Static);
    let known = match flow {
        _ if is_still => true,
        _ if facts.momentum_parts.is_empty() => false,
        Flow::Observer(Observer::Eulerian) | Flow::Velocity => true,
        Flow::Observer(observer) => facts.flows.contains(&observer) && !facts.changes_with_time,
        Flow::AngularMomentum | Flow::AngularVelocity => law.equator().is_some() && !facts.changes_with_time,
    };
    if !known {
        let problem = "matter cannot move so under this law".to_owned();
        let help = if facts.momentum_parts.is_empty() {
            "light has no frequency under this law: use flow = \"static\""
        } else {
            "use flow = \"static\", \"eulerian\" or { velocity = [...] }"
        };
        table.reader.fault(SpannedError { place: node.place, problem, help: help.to_owned() });
        return None;
    }
    Some((flow, nodes))
}
