//! Noise everywhere (thesis §2.4): n = n₀ + amplitude · Σ 2⁻ʲ noise(2ʲ · frequency · (x − c)).

use std::sync::Arc;

use glam::DVec3;

use super::{CENTER, Kind, Medium, Surroundings, center};
use crate::document::reader::TableReader;
use crate::document::values::{number, positive, whole};
use crate::document::{Key, keys};
use crate::model::{Row, Wgsl, row};

/// `amplitude` of a sum about n₀.
pub(super) const AMPLITUDE: Key = keys! {
    amplitude: "number" = "required",
        "of the noise, which reaches 125/64 · (2 − 2^(1 − octaves)) times it: n must stay above 0; textured: where light goes in or out, with straight paths inside";
}[0];
/// `frequency`.
pub(super) const FREQUENCY: Key = keys! { frequency: "number above 0" = "required", "lattice cells a unit length"; }[0];
/// `octaves`.
pub(super) const OCTAVES: Key = keys! { octaves: "whole number, 1 to 8" = "1", "terms of the noise"; }[0];
/// `seed`.
pub(super) const SEED: Key = keys! { seed: "whole number" = "0", "chooses the noise"; }[0];

pub static KIND: Kind = Kind {
    name: "noise",
    keys: &[
        CENTER,
        keys! {
            n0: "number above 0" = "1", "n₀ of n = n₀ + amplitude · Σ 2⁻ʲ noise(2ʲ · frequency · (x − center))";
        }[0],
        AMPLITUDE,
        FREQUENCY,
        OCTAVES,
        SEED,
    ],
    read: |table, around, _| Some(Arc::new(Noise::read(table, table.or("n0", 1.0, positive), around)?)),
};

/// A fractal sum of noise about n₀.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Noise {
    /// c, a point of the lattice.
    pub center: DVec3,
    /// n₀.
    pub n0: f64,
    /// So small that n stays positive.
    pub amplitude: f64,
    /// Lattice cells a unit length.
    pub frequency: f64,
    /// Terms of the sum, 1 to 8.
    pub octaves: u32,
    /// Chooses the lattice's values.
    pub seed: u32,
}

impl Noise {
    /// What the sum of so many octaves stays within: at the middle of a cell a Catmull–Rom spline through values of ±1 reaches 5/4,
    /// and three of them, one along each axis, 125/64.
    #[must_use]
    pub fn reach(octaves: u32) -> f64 {
        125.0 / 64.0 * (2.0 - 2.0_f64.powi(1 - octaves.cast_signed()))
    }

    /// About an index of n₀.
    pub(super) fn read(table: &TableReader, n0: f64, around: Surroundings) -> Option<Self> {
        let center = center(table, around);
        let amplitude = table.required("amplitude", "0.1", number);
        let frequency = table.required("frequency", "1", positive);
        let octaves = table.or("octaves", 1, whole(1..=8));
        let seed = table.or("seed", 0, whole(0..=u32::MAX));
        let (amplitude, reach) = (amplitude?, Self::reach(octaves));
        if amplitude.abs() * reach >= n0 {
            let problem = format!("n could fall to {:.4}, and must stay above 0", n0 - amplitude.abs() * reach);
            // Rounded down, and never to n₀/reach itself.
            let most = ((n0 / reach * 1e3).ceil() - 1.0) / 1e3;
            table.fault(
                &["amplitude"],
                problem,
                format!("so much noise goes up to {reach} times its amplitude: {most} would do"),
            );
            return None;
        }
        Some(Self { center, n0, amplitude, frequency: frequency?, octaves, seed })
    }

    pub(super) fn row(&self) -> Row {
        row! {
            center: Vec3(self.center),
            n0: Float(self.n0),
            amplitude: Float(self.amplitude),
            frequency: Float(self.frequency),
            octaves: Uint(self.octaves),
            seed: Uint(self.seed),
        }
    }
}

impl Medium for Noise {
    fn parts(&self) -> Vec<Wgsl> {
        Wgsl::parts(&["medium/noise", "medium/fractal_noise"])
    }

    fn values(&self, _: u32) -> Row {
        self.row()
    }

    fn index(&self, _: DVec3) -> Option<f64> {
        None
    }

    /// An octave is four layers of points, and their sum.
    fn terms(&self) -> u32 {
        5 * self.octaves
    }
}
