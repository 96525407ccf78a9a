//! `[law]`: how light travels.

use super::files::Files;
use super::media::{self, Surroundings};
use crate::scene::document::reader::TableReader;
use crate::scene::document::values::{not_negative, not_zero, number, positive, text, vector, whole, word};
use crate::scene::document::{Node, Value};
use crate::scene::{Falloff, FlowField, FlowOrder, Law, Medium, SchwarzschildForm, Source};
use glam::DVec3;

#[derive(Clone, Copy)]
enum Kind {
    Straight,
    Schwarzschild,
    Sources,
    Lorenz,
    Rossler,
    Medium,
}

const KINDS: &[(&str, Kind)] = &[
    ("straight", Kind::Straight),
    ("schwarzschild", Kind::Schwarzschild),
    ("sources", Kind::Sources),
    ("lorenz", Kind::Lorenz),
    ("rossler", Kind::Rossler),
    ("medium", Kind::Medium),
];

/// None if the law cannot be used; straight lines if there is none.
pub fn read(root: &TableReader, files: &mut Files) -> Option<Law> {
    if root.node("law").is_none() {
        return Some(Law::Straight);
    }
    let table = root.subtable("law", "law")?;
    let kind = table.decide("kind", Kind::Straight, word(KINDS, &["parametric", "wgsl"]));
    let law = kind.and_then(|kind| match kind {
        Kind::Straight => Some(Law::Straight),
        Kind::Schwarzschild => Some(schwarzschild(&table)),
        Kind::Sources => sources(&table),
        Kind::Lorenz => Some(lorenz(&table)),
        Kind::Rossler => Some(rossler(&table)),
        Kind::Medium => medium(&table, files),
    });
    table.finish();
    law
}

fn schwarzschild(table: &TableReader) -> Law {
    let forms = &[("path", SchwarzschildForm::Path), ("geodesic", SchwarzschildForm::Geodesic)];
    Law::Schwarzschild {
        mass: table.or("mass", 1.0, positive),
        center: table.or("center", DVec3::ZERO, vector),
        form: table.or("form", SchwarzschildForm::Path, word(forms, &[])),
    }
}

fn lorenz(table: &TableReader) -> Law {
    Law::Flow {
        field: FlowField::Lorenz {
            sigma: table.or("sigma", 10.0, number),
            rho: table.or("rho", 28.0, number),
            beta: table.or("beta", 8.0 / 3.0, number),
        },
        order: order(table),
    }
}

fn rossler(table: &TableReader) -> Law {
    Law::Flow {
        field: FlowField::Rossler {
            alpha: table.or("alpha", 0.375, number),
            beta: table.or("beta", 2.0, number),
            gamma: table.or("gamma", 4.0, number),
        },
        order: order(table),
    }
}

fn order(table: &TableReader) -> FlowOrder {
    match table.or("order", 1, whole(1..=2)) {
        1 => FlowOrder::Velocity,
        _ => FlowOrder::Acceleration,
    }
}

fn sources(table: &TableReader) -> Option<Law> {
    let tables = table.subtables("sources", "law.sources");
    if tables.is_empty() {
        let help = "add [[law.sources]] with position = [0, 0, 0] and strength = 1";
        table.fault(&["sources", "kind"], "a law of sources needs at least one", help);
        return None;
    }
    // All are read before any is missed.
    let sources: Vec<Option<Source>> = tables.into_iter().map(source).collect();
    sources.into_iter().collect::<Option<_>>().map(Law::Sources)
}

fn source(table: TableReader) -> Option<Source> {
    table.or("kind", (), |node| match text(node)? {
        "line" => Err(node.fault("gravity lines are not supported yet", "available: center")),
        _ => word(&[("center", ())], &[])(node),
    });
    let position = table.required("position", "[0, 0, 0]", vector);
    let strength = table.required("strength", "1", not_zero);
    let capture = table.or("capture", 0.0, not_negative);
    let falloff = match table.node("falloff") {
        Some(node) => falloff(&table, node),
        None => Some(Falloff::InverseSquare),
    };
    table.finish();
    Some(Source { position: position?, strength: strength?, falloff: falloff?, capture })
}

fn falloff(table: &TableReader, node: &Node) -> Option<Falloff> {
    const CHOICES: &str = "\"inverse-square\", { cubic = R } or { yukawa = mu }";
    match &node.value {
        Value::Text(word) if word == "inverse-square" => return Some(Falloff::InverseSquare),
        Value::Table(_) => {}
        _ => {
            table.reader.fault(node.expected(CHOICES));
            return None;
        }
    }
    let table = table.reader.open("law.sources.falloff", node)?;
    let given = table.required_one_of(&["cubic", "yukawa"], CHOICES);
    let value = given.and_then(|(key, node)| Some((key, table.reader.accept(positive(node))?)));
    table.finish();
    let (key, value) = value?;
    Some(match key {
        "cubic" => Falloff::Cubic { radius: value },
        _ => Falloff::Yukawa { mu: value },
    })
}

fn medium(table: &TableReader, files: &mut Files) -> Option<Law> {
    let node = table.required_node("index", "{ kind = \"maxwell-fisheye\", n0 = 2, a = 1 }")?;
    let medium = media::read(table, node, "medium", Surroundings::default(), files)?;
    if matches!(medium, Medium::Textured(_)) {
        let problem = "a textured index is that of surfaces, and space has none";
        table.fault(&["index"], problem, "use kind = \"noise\", or give it to an object as `interior`");
        return None;
    }
    Some(Law::Medium(medium))
}
