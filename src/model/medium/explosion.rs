//! Disturbed air (W04 Fig. 4d): n = 1 + amplitude · ξ(r/R) · Σ 2⁻ʲ noise(2ʲ · frequency · (x − c)), 1 outside a ball.

use std::sync::Arc;

use glam::DVec3;

use super::noise::{FREQUENCY, OCTAVES, SEED};
use super::{CENTER, Kind, Medium, RADIUS, center, length};
use crate::document::keys;
use crate::document::values::{number_where, positive, whole};
use crate::model::{Row, Wgsl, row};

pub static KIND: Kind = Kind {
    name: "explosion",
    keys: &[
        CENTER,
        RADIUS,
        keys! {
            amplitude: "number between -0.5 and 0.5" = "required", "of the noise: n = 1 + amplitude · noise, falling to 1 at R";
        }[0],
        FREQUENCY,
        OCTAVES,
        SEED,
    ],
    read: |table, around, _| {
        let amplitude = number_where("a number between -0.5 and 0.5", |x| x.abs() < 0.5);
        let (center, radius) = (center(table, around), length(table, "radius", "3", around));
        let amplitude = table.required("amplitude", "0.1", amplitude);
        let frequency = table.required("frequency", "1", positive);
        let octaves = table.or("octaves", 1, whole(1..=8));
        let seed = table.or("seed", 0, whole(0..=u32::MAX));
        let (radius, amplitude, frequency) = (radius?, amplitude?, frequency?);
        Some(Arc::new(Explosion { center, radius, amplitude, frequency, octaves, seed }))
    },
};

/// Noise in a ball.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Explosion {
    /// Centre c of the disturbed region.
    pub center: DVec3,
    /// Its radius R: outside n = 1.
    pub radius: f64,
    /// In (−0.5, 0.5), so that n stays positive.
    pub amplitude: f64,
    /// Lattice cells a unit length.
    pub frequency: f64,
    /// Terms of the sum, 1 to 8.
    pub octaves: u32,
    /// Chooses the lattice's values.
    pub seed: u32,
}

impl Medium for Explosion {
    fn parts(&self) -> Vec<Wgsl> {
        Wgsl::parts(&["medium/explosion", "medium/fractal_noise"])
    }

    fn values(&self, _: u32) -> Row {
        row! {
            center: Vec3(self.center),
            radius: Float(self.radius),
            amplitude: Float(self.amplitude),
            frequency: Float(self.frequency),
            octaves: Uint(self.octaves),
            seed: Uint(self.seed),
        }
    }

    fn index(&self, x: DVec3) -> Option<f64> {
        (x.distance(self.center) >= self.radius).then_some(1.0)
    }

    fn edge(&self) -> Option<(DVec3, f64)> {
        Some((self.center, self.radius))
    }

    fn terms(&self) -> u32 {
        self.octaves
    }
}
