//! Tests the index, pull and length of every medium, in 32 and in 64 bits, against an independent version in f64.
//!
//! The tested pull is the analytic derivative of the index, and is compared with central differences of the index. Bounds
//! count roundings: u is the unit of rounding of the precision.

mod formulas;
mod noise;
mod profile;

use std::sync::Arc;

use bentray::model::Medium;
use bentray::model::Value::{Float, Vec3 as V3};
use bentray::model::medium::{Noise, Textured};
use glam::{DVec3, Vec4};

use super::reals::{REALS, U64, joined, joined3, split};
use super::{Errors, Random, U, vectors, wide};
use crate::support::{gpu, probe::Probe, scene};

/// The radius of the bounding sphere, which a constant medium lets rays cross in one step.
const BOUND: f64 = 64.0;

/// The wavelength of the light in micrometers, for which the CPU computes indices.
const WAVELENGTH: f64 = 1e-3 * bentray::model::medium::D_LINE;

/// The expected values at a position, each with a bound on its error.
struct Want {
    n: (f64, f64),
    pull: (DVec3, f64),
    length: (f64, f64),
}

/// A medium, and its known properties.
struct Case {
    name: &'static str,
    parts: &'static [&'static str],
    /// The medium as a scene has it; every number is exact in f32.
    index: &'static str,
    center: DVec3,
    /// The smallest and the largest distance from the center at which the index is tested.
    reach: [f64; 2],
    /// Whether it is as regular at its center as elsewhere.
    regular: bool,
    /// Returns the expected values at a position, for roundings of this size.
    want: fn(DVec3, f64) -> Want,
    /// Returns `true` if slope or length jump within this distance of the position, so that rounding decides.
    undecided: fn(DVec3, f64) -> bool,
}

impl Case {
    fn medium(&self) -> Arc<dyn Medium> {
        let text = format!(
            "[rays]\nbounding_sphere = {{ radius = {BOUND} }}\n[[objects]]\nshape = \"box\"\ninterior = {}\n",
            self.index
        );
        scene(&text).objects[0].interior().expect("an interior").medium.clone()
    }

    fn probe(&self, real: &'static str) -> Probe {
        let medium = self.medium();
        let parts = [self.parts, &["state/loops", "law/bound", "law/leaving", "surface/region_none", real]].concat();
        Probe::new(&parts)
            .list("media", "MEDIA_COUNT", [medium.values(0)])
            .bind("profile", medium.points())
            .bind("spectrum", [vec![("wavelength", Float(WAVELENGTH))]])
            .bind("bound", [vec![("center", V3(DVec3::ZERO)), ("radius", Float(BOUND))]])
    }

    fn check(&self) {
        self.in_32_bits();
        self.in_64_bits();
    }

    fn in_32_bits(&self) {
        let mut random = Random::new(51);
        let center = self.center.as_vec3();
        let mut places: Vec<_> =
            vectors(&mut random, 3000, self.reach[0], self.reach[1]).iter().map(|d| center + *d).collect();
        if self.regular {
            places.push(center);
        }
        let inputs: Vec<[Vec4; 1]> = places.iter().map(|x| [x.extend(0.0)]).collect();
        let body = "let x = p0.xyz;
            put(0u, vec4f(medium_pull(x), medium_index(x)));
            put(1u, vec4f(medium_length(x)));";
        let out = self.probe("real/f32").run::<1, 2>(&gpu(), body, &inputs);
        let found = inputs
            .iter()
            .zip(&out)
            .map(|(input, [pull, length])| (wide(input[0]), f64::from(pull.w), wide(*pull), f64::from(length.x)));
        self.compare("32 bits", U, found);
    }

    fn in_64_bits(&self) {
        let mut random = Random::new(52);
        let [near, far] = self.reach;
        let mut places: Vec<DVec3> =
            (0..3000).map(|_| self.center + random.direction() * random.log(near, far)).collect();
        places.extend(DVec3::AXES.iter().flat_map(|axis| [near, far].map(|r| self.center + r * *axis)));
        if self.regular {
            places.push(self.center);
        }
        let inputs: Vec<[Vec4; 3]> = places.iter().map(|x| x.to_array().map(split)).collect();
        let body = "let x = Real3(real(p0), real(p1), real(p2));
            put_real(0u, medium_index(x));
            put_real3(1u, medium_pull(x));
            put_real(4u, medium_length(x));";
        let out = self.probe("real/f64").stub(REALS).run::<3, 5>(&gpu(), body, &inputs);
        let found =
            places.iter().zip(&out).map(|(x, rows)| (*x, joined(rows[0]), joined3(&rows[1..]), joined(rows[4])));
        self.compare("64 bits", U64, found);
    }

    fn compare(&self, bits: &str, u: f64, found: impl Iterator<Item = (DVec3, f64, DVec3, f64)>) {
        println!("{} in {bits}", self.name);
        let medium = self.medium();
        let [mut indices, mut pulls, mut lengths] = ["index", "pull", "length"].map(Errors::of);
        let mut known = Errors::of("the host's index");
        for (x, n, pull, length) in found {
            if (self.undecided)(x, 16.0 * u * x.distance(self.center)) {
                continue;
            }
            let want = (self.want)(x, u);
            indices.check(n, want.n.0, want.n.1, x);
            lengths.check(length, want.length.0, want.length.1, x);
            for k in 0..3 {
                pulls.check(pull[k], want.pull.0[k], want.pull.1, x);
            }
            if let Some(n) = medium.index(x) {
                known.check(n, want.n.0, (self.want)(x, 2.0 * U64).n.1, x);
            }
        }
        indices.report();
        pulls.report();
        lengths.report();
        if medium.downcast::<Noise>().is_none() && medium.downcast::<Textured>().is_none() {
            known.report();
        }
    }

    /// Checks that the pull is the slope of n²/2, by differences over 10⁻⁴ of the length, which err by 10⁻⁸ of third derivatives.
    fn pull_is_the_slope(&self, tolerance: f64) {
        let mut random = Random::new(53);
        let mut tried = 0;
        for _ in 0..3000 {
            let x = self.center + random.direction() * random.log(self.reach[0], self.reach[1]);
            let want = (self.want)(x, U64);
            let h = 1e-4 * want.length.0;
            let n = |x: DVec3| (self.want)(x, U64).n.0;
            // Near n = 0 the root is not smooth.
            if (self.undecided)(x, 2.0 * h) || n(x) < 1e-2 {
                continue;
            }
            tried += 1;
            let slope = DVec3::AXES.map(|e| (n(x + h * e).powi(2) - n(x - h * e).powi(2)) / (4.0 * h));
            let off = (DVec3::from_array(slope) - want.pull.0).length();
            let size = want.pull.0.length() + n(x).powi(2) / want.length.0;
            assert!(off <= tolerance * size, "{}: {off:e} of {size:e} at {x}", self.name);
        }
        assert!(tried > 1000, "{}: only {tried}", self.name);
    }
}

/// Returns a bound on the error of √square, if square has this error.
fn root_error(square: f64, error: f64) -> f64 {
    if square > 2.0 * error { error / square.sqrt() } else { 2.0 * error.sqrt() }
}

/// Returns a bound on the relative error of the exponential function, if its argument has the error δ: WGSL allows
/// 3 + 2 |z| units in the last place, of 2u each.
fn exp_error(z: f64, delta: f64, u: f64) -> f64 {
    delta + (6.0 + 4.0 * z.abs()) * u
}
