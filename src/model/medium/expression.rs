//! A user-defined formula of n in x, y, z and r; its gradient is derived.

use std::sync::Arc;

use glam::DVec3;

use super::{Kind, Medium, MediumProperties, Surroundings, center};
use crate::assets::Formula;
use crate::document::reader::TableReader;
use crate::document::values::{positive_length, text};
use crate::document::{Node, keys};
use crate::model::{Row, fields};

pub static KIND: Kind = Kind {
    name: "expression",
    keys: keys! {
        n: "formula" = "required",
            "index as a function of x, y, z and r, with numbers, pi, + - * / ^ ( ), sqrt, exp, log, sin, cos, tan, sinh, cosh, tanh, atan, abs, min and max; the gradient is derived; rays fail where n is not above 0";
        center: "[x, y, z]" = "the object's, or [0, 0, 0]", "origin of x, y, z and r; scene units";
        scale: "number above 0" = "the object's radius, or 1",
            "length scale of n, in scene units; steps are a fraction of it";
    },
    read: |table, around, _| Some(Arc::new(Expression::read(table, around)?)),
};

fields! {
    /// A medium defined by a formula.
    Expression(table: &TableReader, around: Surroundings) {
        /// The origin of x, y, z and r.
        center: DVec3 as Vec3 = Some(center(table, around)),
        /// The length over which n changes.
        scale: f64 as Float = Some(table.or("scale", around.radius.unwrap_or(1.0), positive_length)),
        /// The formula of n relative to the center. Rays fail where it has no positive value.
        n: Formula = table.required_node("n", "\"1 + 0.1 * exp(-r^2)\"").and_then(|node| formula(table, node)),
    }
}

fn formula(table: &TableReader, node: &Node) -> Option<Formula> {
    let reader = table.reader;
    let Ok(written) = text(node) else {
        reader.fault(node.fault("expected a formula, in quotes", "for a constant index, use kind = \"constant\""));
        return None;
    };
    match Formula::parse(written) {
        Ok(formula) => {
            let nowhere = formula.constant().filter(|n| *n <= 0.0);
            if let Some(n) = nowhere {
                let problem = format!("expected an index above 0, found {n}");
                reader.fault_inside(node, 0..written.len(), problem, String::new());
            }
            nowhere.is_none().then_some(formula)
        }
        Err(error) => {
            reader.fault_inside(node, error.place, error.problem, error.help);
            None
        }
    }
}

impl Medium for Expression {
    fn facts(&self) -> MediumProperties<'_> {
        MediumProperties {
            formula: Some(&self.n),
            ..MediumProperties::of(&["medium/expression", "medium/formula", "medium/finite"])
        }
    }

    fn values(&self, _: u32) -> Row {
        self.row()
    }

    fn index(&self, x: DVec3) -> Option<f64> {
        Some(self.n.value(x - self.center))
    }
}
