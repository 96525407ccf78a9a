//! Noise where light goes in or out, and straight paths between (thesis §5.2.1): for interiors only.

use std::sync::Arc;

use glam::DVec3;

use super::noise::{AMPLITUDE, FREQUENCY, Noise, OCTAVES, SEED};
use super::{CENTER, Kind, Medium, constant};
use crate::document::values::positive;
use crate::model::{ClosedForm, Row, STRAIGHT, Wgsl};

pub static KIND: Kind = Kind {
    name: "textured",
    keys: &[constant::KIND.keys[0], CENTER, AMPLITUDE, FREQUENCY, OCTAVES, SEED],
    read: |table, around, _| {
        let n = table.required("n", "1.5", positive);
        let noise = Noise::read(table, n.unwrap_or(f64::INFINITY), around);
        Some(Arc::new(Textured(Noise { n0: n?, ..noise? })))
    },
};

/// Noise over a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Textured(pub Noise);

impl Medium for Textured {
    fn parts(&self) -> Vec<Wgsl> {
        Wgsl::parts(&["medium/textured", "medium/fractal_noise"])
    }

    fn values(&self, _: u32) -> Row {
        self.0.row()
    }

    fn index(&self, _: DVec3) -> Option<f64> {
        None
    }

    fn closed_form(&self, _: bool) -> Option<&'static ClosedForm> {
        Some(&STRAIGHT)
    }

    fn bends(&self) -> bool {
        false
    }

    fn is_of_surfaces(&self) -> bool {
        true
    }

    fn terms(&self) -> u32 {
        self.0.terms()
    }
}
