//! The Lorenz system: F = (σ(y−x), ρx − y − xz, xy − βz) (G95 §2.2, W04 §5.1).

use std::sync::Arc;

use super::flow::{FlowOrder, ORDER};
use super::{Kind, Law, LawProperties};
use crate::document::keys;
use crate::document::reader::TableReader;
use crate::document::values::number;
use crate::model::{Binding, Wgsl, fields};

pub static KIND: Kind = Kind {
    name: "lorenz",
    keys: &[
        keys! { sigma: "number" = "10", "σ"; }[0],
        keys! { rho: "number" = "28", "ρ"; }[0],
        keys! { beta: "number" = "8/3", "β"; }[0],
        ORDER,
    ],
    read: |table, _| Some(Arc::new(Lorenz::read(table)?)),
};

fields! {
    /// The Lorenz system.
    Lorenz(table: &TableReader) {
        /// The parameter σ, by default 10.
        sigma: f64 as Float = Some(table.or("sigma", 10.0, number)),
        /// The parameter ρ, by default 28.
        rho: f64 as Float = Some(table.or("rho", 28.0, number)),
        /// The parameter β, by default 8/3.
        beta: f64 as Float = Some(table.or("beta", 8.0 / 3.0, number)),
        /// The relation of the field to the ray.
        order: FlowOrder = Some(FlowOrder::read(table)),
    }
}

impl Law for Lorenz {
    fn parts(&self) -> Vec<Wgsl> {
        self.order.parts("law/field_lorenz")
    }

    fn values(&self) -> Vec<Binding> {
        vec![Binding::one("flow", self.row())]
    }

    fn facts(&self) -> LawProperties<'_> {
        self.order.facts()
    }
}
