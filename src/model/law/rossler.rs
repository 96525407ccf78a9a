//! Rössler's system: F = (−(y+z), x + αy, β + z(x−γ)) (G95 §2.2; W04 prints −(x+z) in the first row, a misprint).

use std::sync::Arc;

use super::flow::{FlowOrder, ORDER};
use super::{Facts, Kind, Law};
use crate::document::keys;
use crate::document::values::number;
use crate::model::{Binding, Wgsl, row};

pub static KIND: Kind = Kind {
    name: "rossler",
    keys: &[
        keys! { alpha: "number" = "0.375", "α"; }[0],
        keys! { beta: "number" = "2", "β"; }[0],
        keys! { gamma: "number" = "4", "γ"; }[0],
        ORDER,
    ],
    read: |table, _| {
        Some(Arc::new(Rossler {
            alpha: table.or("alpha", 0.375, number),
            beta: table.or("beta", 2.0, number),
            gamma: table.or("gamma", 4.0, number),
            order: FlowOrder::read(table),
        }))
    },
};

/// Rössler's system.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rossler {
    /// α, by default 0.375.
    pub alpha: f64,
    /// β, by default 2.
    pub beta: f64,
    /// γ, by default 4.
    pub gamma: f64,
    /// What the field is to the ray.
    pub order: FlowOrder,
}

impl Law for Rossler {
    fn parts(&self) -> Vec<Wgsl> {
        self.order.parts("law/field_rossler")
    }

    fn values(&self) -> Vec<Binding> {
        let row = row! { alpha: Float(self.alpha), beta: Float(self.beta), gamma: Float(self.gamma) };
        vec![Binding::one("flow", row)]
    }

    fn facts(&self) -> Facts<'_> {
        self.order.facts()
    }
}
