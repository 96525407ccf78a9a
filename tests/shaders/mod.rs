//! Compares every shader function with an independent f64 form of it.
//!
//! Inputs are rounded to f32 before the f64 form uses them, and bounds on errors follow from rounding: an f32 operation errs by
//! at most U of its result, and where terms cancel the error is U of the *terms*. Each bound is a small count of operations
//! times U times the size of the terms, written where it is used.

#![allow(clippy::float_cmp, reason = "what a shader passes on, it passes on bit by bit")]
#![allow(clippy::many_single_char_names, reason = "the formulas' own letters")]

mod boxes;
mod cameras;
mod control;
mod curves;
mod doubles;
mod embedded;
mod emitters;
mod ends;
mod expressions;
mod grid;
mod images;
mod intervals;
mod laws;
mod lights;
mod lines;
mod media;
mod medium;
mod numbers;
mod paths;
mod planned;
mod reals;
mod rounding;
mod sampling;
pub(crate) mod schemes;
mod shapes;
mod shots;
mod sources;
mod steps;
mod surfaces;
mod triangles;

use std::fmt::Debug;

use glam::{DVec3, Vec3, Vec4};

/// Half the distance from 1 to the next f32: the relative error of one rounding.
pub const U: f64 = 5.960_464_477_539_063e-8;

/// A small random generator, so that inputs never change.
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ 0x1234_5678_9abc_def0)
    }

    /// Returns a number in [0, 1).
    pub fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let mixed = (self.0 ^ (self.0 >> 33)).wrapping_mul(0xff51_afd7_ed55_8ccd);
        ((mixed ^ (mixed >> 33)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub fn within(&mut self, lo: f64, hi: f64) -> f64 {
        lo + (hi - lo) * self.unit()
    }

    /// Returns a number with a uniformly distributed logarithm.
    pub fn log(&mut self, lo: f64, hi: f64) -> f64 {
        self.within(lo.ln(), hi.ln()).exp()
    }

    pub fn direction(&mut self) -> DVec3 {
        let z = self.within(-1.0, 1.0);
        let angle = self.within(0.0, std::f64::consts::TAU);
        let rho = (1.0 - z * z).sqrt();
        DVec3::new(rho * angle.cos(), rho * angle.sin(), z)
    }

    /// Returns an f32 vector with a length between `lo` and `hi`.
    pub fn vector(&mut self, lo: f64, hi: f64) -> Vec3 {
        (self.direction() * self.log(lo, hi)).as_vec3()
    }
}

/// Returns directions that are special cases: axes, diagonals, zeros of both signs, and components of very different sizes.
pub fn awkward_directions() -> Vec<Vec3> {
    let mut all = Vec::new();
    for x in [-1.0_f32, -0.0, 0.0, 1.0, 1e-7] {
        for y in [-1.0_f32, -0.0, 0.0, 1.0, -1e-7] {
            for z in [-1.0_f32, -0.0, 0.0, 1.0, 1e-20] {
                let d = Vec3::new(x, y, z);
                if d.length() > 0.5 {
                    all.push(d / d.length());
                }
            }
        }
    }
    all
}

/// Returns random vectors with lengths between `lo` and `hi`, and awkward ones of length `lo`, their geometric mean and `hi`.
pub fn vectors(random: &mut Random, count: usize, lo: f64, hi: f64) -> Vec<Vec3> {
    let mut all: Vec<Vec3> = (0..count).map(|_| random.vector(lo, hi)).collect();
    for size in [lo, (lo * hi).sqrt(), hi] {
        all.extend(awkward_directions().iter().map(|d| *d * size as f32));
    }
    all
}

/// Returns a vec3f as an input row.
pub fn row(v: Vec3, w: f32) -> Vec4 {
    v.extend(w)
}

/// Returns the same vector in f64, which is exact.
pub fn wide(v: Vec4) -> DVec3 {
    v.truncate().as_dvec3()
}

/// The errors of one function over its inputs, each relative to its bound.
pub struct Errors {
    what: &'static str,
    count: usize,
    worst: f64,
    ratio: f64,
    at: String,
}

impl Errors {
    pub fn of(what: &'static str) -> Self {
        Self { what, count: 0, worst: 0.0, ratio: 0.0, at: String::new() }
    }

    /// Compares one value with its exact form, with a bound on the difference.
    pub fn check(&mut self, got: impl Into<f64>, want: f64, bound: f64, at: impl Debug) {
        self.count += 1;
        let got = got.into();
        let error = (got - want).abs();
        let error = if error.is_nan() { f64::INFINITY } else { error };
        // Numbers below the normal range of f32 may be flushed to 0, also on the way to a result that is a few thousand times as large.
        let ratio = error / (bound + 4096.0 * f64::from(f32::MIN_POSITIVE));
        self.worst = self.worst.max(error);
        if ratio > self.ratio || ratio.is_nan() {
            self.ratio = ratio;
            self.at = format!("{got:e} for {want:e} (bound {bound:e}) at {at:?}");
        }
    }

    pub fn check3(&mut self, got: Vec4, want: DVec3, bound: f64, at: impl Debug) {
        for k in 0..3 {
            self.check(got[k], want[k], bound, &at);
        }
    }

    /// Prints the largest error, and fails if it exceeds its bound.
    pub fn report(&self) {
        println!(
            "{}: {} values, error at most {:.1e}, {:.2} of its bound",
            self.what, self.count, self.worst, self.ratio
        );
        assert!(self.count > 0, "{}: nothing was tried", self.what);
        assert!(self.ratio <= 1.0, "{}: {}", self.what, self.at);
    }
}

/// The certain part of the result of an intersection, if each decision may be wrong by a rounding error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Verdict {
    Miss,
    /// A hit at a fraction between these.
    Hit(f64, f64),
    /// Rounding decides.
    Open,
}

impl Verdict {
    /// Returns the verdict from the results under every combination of errors.
    pub fn of(results: &[Option<f64>]) -> Self {
        let found: Vec<f64> = results.iter().flatten().copied().collect();
        let lo = found.iter().copied().fold(f64::INFINITY, f64::min);
        let hi = found.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        match found.len() {
            0 => Self::Miss,
            n if n == results.len() && hi - lo < 0.02 => Self::Hit(lo, hi),
            _ => Self::Open,
        }
    }
}

/// Compares intersections with verdicts; rounding may decide at most a fraction `open` of them.
pub fn check_hits(what: &'static str, open: f64, cases: impl IntoIterator<Item = (f32, Verdict, f64, String)>) {
    let (mut hits, mut misses, mut undecided) = (0, 0, 0);
    for (t, verdict, slack, at) in cases {
        let t64 = f64::from(t);
        match verdict {
            Verdict::Miss => {
                misses += 1;
                assert!(t64 > 1.5, "{what}: hit at {t}, which is a miss: {at}");
            }
            Verdict::Hit(lo, hi) => {
                hits += 1;
                assert!(t64 >= lo - slack && t64 <= hi + slack, "{what}: {t} is not in [{lo}, {hi}] ± {slack:e}: {at}");
            }
            Verdict::Open => undecided += 1,
        }
    }
    let all = hits + misses + undecided;
    println!("{what}: {hits} hits, {misses} misses, {undecided} for rounding to decide");
    assert!(hits * 20 > all && misses * 20 > all, "{what}: the inputs are one-sided");
    assert!(f64::from(undecided) <= open * f64::from(all), "{what}: {undecided} of {all} were open");
}
