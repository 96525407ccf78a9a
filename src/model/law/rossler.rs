//! The Rössler system: F = (−(y+z), x + αy, β + z(x−γ)) (G95 §2.2; W04 prints −(x+z) in the first row, a misprint).

use std::sync::Arc;

use super::flow::{FlowOrder, ORDER};
use super::{Kind, Law, LawProperties};
use crate::document::keys;
use crate::document::reader::TableReader;
use crate::document::values::number;
use crate::model::{Binding, Wgsl, fields};

pub static KIND: Kind = Kind {
    name: "rossler",
    keys: &[
        keys! { alpha: "number" = "0.375", "α"; }[0],
        keys! { beta: "number" = "2", "β"; }[0],
        keys! { gamma: "number" = "4", "γ"; }[0],
        ORDER,
    ],
    read: |table, _| Some(Arc::new(Rossler::read(table)?)),
};

fields! {
    /// The Rössler system.
    Rossler(table: &TableReader) {
        /// The parameter α, by default 0.375.
        alpha: f64 as Float = Some(table.or("alpha", 0.375, number)),
        /// The parameter β, by default 2.
        beta: f64 as Float = Some(table.or("beta", 2.0, number)),
        /// The parameter γ, by default 4.
        gamma: f64 as Float = Some(table.or("gamma", 4.0, number)),
        /// The relation of the field to the ray.
        order: FlowOrder = Some(FlowOrder::read(table)),
    }
}

impl Law for Rossler {
    fn parts(&self) -> Vec<Wgsl> {
        self.order.parts("law/field_rossler")
    }

    fn values(&self) -> Vec<Binding> {
        vec![Binding::one("flow", self.row())]
    }

    fn facts(&self) -> LawProperties<'_> {
        self.order.facts()
    }
}
