//! Lorenz's system: F = (σ(y−x), ρx − y − xz, xy − βz) (G95 §2.2, W04 §5.1).

use std::sync::Arc;

use super::flow::{FlowOrder, ORDER};
use super::{Facts, Kind, Law};
use crate::document::keys;
use crate::document::values::number;
use crate::model::{Binding, Wgsl, row};

pub static KIND: Kind = Kind {
    name: "lorenz",
    keys: &[
        keys! { sigma: "number" = "10", "σ"; }[0],
        keys! { rho: "number" = "28", "ρ"; }[0],
        keys! { beta: "number" = "8/3", "β"; }[0],
        ORDER,
    ],
    read: |table, _| {
        Some(Arc::new(Lorenz {
            sigma: table.or("sigma", 10.0, number),
            rho: table.or("rho", 28.0, number),
            beta: table.or("beta", 8.0 / 3.0, number),
            order: FlowOrder::read(table),
        }))
    },
};

/// Lorenz's system.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lorenz {
    /// σ, by default 10.
    pub sigma: f64,
    /// ρ, by default 28.
    pub rho: f64,
    /// β, by default 8/3.
    pub beta: f64,
    /// What the field is to the ray.
    pub order: FlowOrder,
}

impl Law for Lorenz {
    fn parts(&self) -> Vec<Wgsl> {
        self.order.parts("law/field_lorenz")
    }

    fn values(&self) -> Vec<Binding> {
        let row = row! { sigma: Float(self.sigma), rho: Float(self.rho), beta: Float(self.beta) };
        vec![Binding::one("flow", row)]
    }

    fn facts(&self) -> Facts<'_> {
        self.order.facts()
    }
}
