//! Noise where light crosses the surface, with straight paths in between (T §5.2.1); for interiors only.

use std::sync::Arc;

use glam::DVec3;

use super::noise::{AMPLITUDE, FREQUENCY, Noise, OCTAVES, SEED};
use super::{CENTER, Kind, Medium, MediumProperties, constant};
use crate::document::values::positive;
use crate::model::{Row, STRAIGHT};

pub static KIND: Kind = Kind {
    name: "textured",
    keys: &[constant::KIND.keys[0], CENTER, AMPLITUDE, FREQUENCY, OCTAVES, SEED],
    read: |table, around, _| {
        let n = table.required("n", "1.5", positive);
        let noise = Noise::read(table, around, n.unwrap_or(f64::INFINITY))?;
        n.map(|_| Arc::new(Textured(noise)) as Arc<dyn Medium>)
    },
};

/// Noise over a surface.
#[derive(Debug, Clone, PartialEq)]
pub struct Textured(pub Noise);

impl Medium for Textured {
    fn facts(&self) -> MediumProperties<'_> {
        MediumProperties { closed_form: Some(&STRAIGHT), is_of_surfaces: true, ..self.0.facts_by("medium/textured") }
    }

    fn values(&self, first: u32) -> Row {
        self.0.values(first)
    }

    fn index(&self, x: DVec3) -> Option<f64> {
        self.0.index(x)
    }
}
