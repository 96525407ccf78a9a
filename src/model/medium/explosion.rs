//! Disturbed air (W04 Fig. 4d): n = 1 + amplitude · ξ(r/R) · Σ 2⁻ʲ noise(2ʲ · frequency · (x − c)), 1 outside a ball.

use std::sync::Arc;

use glam::DVec3;

use super::noise::{FREQUENCY, OCTAVES, SEED};
use super::{CENTER, Kind, Medium, MediumProperties, RADIUS, Surroundings, center, length};
use crate::document::keys;
use crate::document::reader::TableReader;
use crate::document::values::{number_where, positive, whole};
use crate::model::{Row, fields};

pub static KIND: Kind = Kind {
    name: "explosion",
    keys: &[
        CENTER,
        RADIUS,
        keys! {
            amplitude: "number between -0.5 and 0.5" = "required", "amplitude of the noise: n = 1 + amplitude · noise, falling to 1 at R";
        }[0],
        FREQUENCY,
        OCTAVES,
        SEED,
    ],
    read: |table, around, _| Some(Arc::new(Explosion::read(table, around)?)),
};

fields! {
    /// Noise in a ball.
    Explosion(table: &TableReader, around: Surroundings) {
        /// The center c of the disturbed region.
        center: DVec3 as Vec3 = Some(center(table, around)),
        /// The radius R, outside which n = 1.
        radius: f64 as Float = length(table, "radius", "3", around),
        /// The amplitude, in (−0.5, 0.5), so that n stays positive.
        amplitude: f64 as Float = table.required("amplitude", "0.1", number_where("a number between -0.5 and 0.5", |x| x.abs() < 0.5)),
        /// The number of lattice cells per unit length.
        frequency: f64 as Float = table.required("frequency", "1", positive),
        /// The number of terms of the sum, 1 to 8.
        octaves: u32 as Uint = Some(table.or("octaves", 1, whole(1..=8))),
        /// The seed of the lattice values.
        seed: u32 as Uint = Some(table.or("seed", 0, whole(0..=u32::MAX))),
    }
}

impl Medium for Explosion {
    fn facts(&self) -> MediumProperties<'_> {
        MediumProperties {
            edge: Some((self.center, self.radius)),
            terms: self.octaves,
            ..MediumProperties::of(&["medium/explosion", "medium/fractal_noise"])
        }
    }

    fn values(&self, _: u32) -> Row {
        self.row()
    }

    fn index(&self, x: DVec3) -> Option<f64> {
        (x.distance(self.center) >= self.radius).then_some(1.0)
    }
}
