//! The reader of a law with a line element.

use glam::DVec3;

use super::{Metric, Throat};
use crate::assets::{Field, FormulaError, LineElement, Spacetime, Transform};
use crate::document::Node;
use crate::document::reader::TableReader;
use crate::document::values::{angles, number, point, positive_length, text, time};

pub(super) fn read(table: &TableReader) -> Option<Metric> {
    let element = table.required_node("line_element", "\"-dt^2 + dx^2 + dy^2 + dz^2\"");
    let scale = table.required_node("scale", "\"r\"");
    let captured = table.node("capture_condition");
    let parameters = table.named("parameters", "law.parameters", &|node| table.reader.accept(number(node)));
    let terms = table.named("terms", "law.terms", &|node| written(table, node));
    let rotate = table.or("rotate", DVec3::ZERO, angles);
    let throat = table.optional("throat", positive_length);
    let other = throat.map(|_| table.required("other_mouth", "[1000, 0, 0]", point));
    let (time, center) = (table.or("time", 0.0, time), table.or("center", DVec3::ZERO, point));
    let captured_text = match captured {
        Some(node) => Some(written(table, node)?),
        None => None,
    };
    let (parameters, terms) = (parameters?, terms?);
    let spacetime = Spacetime {
        line_element: written(table, element?)?,
        parameters: parameters.iter().map(|(name, _, value)| (name.clone(), *value)).collect(),
        terms: terms.iter().map(|(name, _, value)| (name.clone(), value.clone())).collect(),
        scale: written(table, scale?)?,
        captured: captured_text,
        throat,
        axes: Transform::new(DVec3::ONE, rotate, DVec3::ZERO).0.matrix3,
    };
    let node_of = |field: Field| match field {
        Field::LineElement => element,
        Field::Scale => scale,
        Field::Captured => captured.or(element),
        Field::Parameter(k) => Some(parameters[k].1),
        Field::Term(k) | Field::TermName(k) => Some(terms[k].1),
    };
    match LineElement::parse(spacetime) {
        Ok(element) => {
            let throat = match throat.zip(other) {
                Some((radius, other)) => Some(Throat::new([center, other?], radius)),
                None => None,
            };
            if throat.is_some() && element.depends_on_time() {
                let problem = "a line element with a throat cannot depend on t";
                table.fault(&["throat"], problem, "remove t from law.line_element, or remove law.throat");
                return None;
            }
            Some(Metric { element, time, center, throat })
        }
        Err((field, FormulaError { place, problem, help })) => {
            let node = node_of(field)?;
            if matches!(field, Field::Parameter(_) | Field::TermName(_)) {
                table.reader.fault(node.fault(problem, help));
            } else {
                table.reader.fault_inside(node, place, problem, help);
            }
            None
        }
    }
}

fn written(table: &TableReader, node: &Node) -> Option<String> {
    let said = text(node).map_err(|_| table.reader.fault(node.fault("expected a formula, in quotes", "")));
    said.ok().map(str::to_owned)
}
