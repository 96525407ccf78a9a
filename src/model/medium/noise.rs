//! Noise everywhere (T §2.4): n = n₀ + amplitude · Σ 2⁻ʲ noise(2ʲ · frequency · (x − c)).

use std::sync::Arc;

use glam::DVec3;

use super::{CENTER, Kind, Medium, MediumProperties, Surroundings, center};
use crate::document::reader::TableReader;
use crate::document::values::{number, positive, whole};
use crate::document::{Key, keys};
use crate::model::{Row, fields};

/// The key `amplitude` of a sum around n₀.
pub(super) const AMPLITUDE: Key = keys! {
    amplitude: "number" = "required",
        "amplitude of the noise, which reaches 125/64 · (2 − 2^(1 − octaves)) times this; n must stay above 0; textured: index at the surface, with straight paths inside";
}[0];
/// The key `frequency`.
pub(super) const FREQUENCY: Key =
    keys! { frequency: "number above 0" = "required", "lattice cells per unit length"; }[0];
/// The key `octaves`.
pub(super) const OCTAVES: Key = keys! { octaves: "whole number, 1 to 8" = "1", "number of octaves of the noise"; }[0];
/// The key `seed`.
pub(super) const SEED: Key = keys! { seed: "whole number" = "0", "seed of the noise"; }[0];

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
    read: |table, around, _| Some(Arc::new(Noise::read(table, around, table.or("n0", 1.0, positive))?)),
};

fields! {
    /// A fractal sum of noise around n₀.
    Noise(table: &TableReader, around: Surroundings, about: f64) {
        /// The lattice point c.
        center: DVec3 as Vec3 = Some(center(table, around)),
        /// The mean index n₀.
        n0: f64 as Float = Some(about),
        /// The amplitude, small enough that n stays positive.
        amplitude: f64 as Float = table.required("amplitude", "0.1", number),
        /// The number of lattice cells per unit length.
        frequency: f64 as Float = table.required("frequency", "1", positive),
        /// The number of terms of the sum, 1 to 8.
        octaves: u32 as Uint = octaves(table, about, amplitude),
        /// The seed of the lattice values.
        seed: u32 as Uint = Some(table.or("seed", 0, whole(0..=u32::MAX))),
    }
}

/// Reads the number of terms, and checks that n stays positive.
fn octaves(table: &TableReader, n0: f64, amplitude: Option<f64>) -> Option<u32> {
    let octaves = table.or("octaves", 1, whole(1..=8));
    let (amplitude, reach) = (amplitude.unwrap_or(0.0).abs(), Noise::reach(octaves));
    if amplitude * reach < n0 {
        return Some(octaves);
    }
    let problem = format!("n could fall to {:.4}, and must stay above 0", n0 - amplitude * reach);
    // Rounded down, and always below n₀/reach.
    let most = ((n0 / reach * 1e3).ceil() - 1.0) / 1e3;
    let help = format!("use an amplitude of {most} or less; the noise reaches {reach} times its amplitude");
    table.fault(&["amplitude"], problem, help);
    None
}

impl Noise {
    /// Returns a bound of the sum over these octaves: at the center of a cell, a Catmull–Rom spline through values of ±1 reaches 5/4, and
    /// the product of three splines, one along each axis, 125/64.
    #[must_use]
    pub fn reach(octaves: u32) -> f64 {
        125.0 / 64.0 * (2.0 - 2.0_f64.powi(1 - octaves.cast_signed()))
    }

    /// Returns its properties with this module; the cost is four layers of lattice points per octave.
    pub(super) fn facts_by(&self, part: &'static str) -> MediumProperties<'_> {
        MediumProperties { terms: 5 * self.octaves, ..MediumProperties::of(&[part, "medium/fractal_noise"]) }
    }
}

impl Medium for Noise {
    fn facts(&self) -> MediumProperties<'_> {
        self.facts_by("medium/noise")
    }

    fn values(&self, _: u32) -> Row {
        self.row()
    }

    fn index(&self, _: DVec3) -> Option<f64> {
        None
    }
}
