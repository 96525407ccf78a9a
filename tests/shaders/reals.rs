//! Passes 64-bit numbers through the f32 rows of a probe without loss.
//!
//! An f64 is the sum of three f32: its first 24 bits, the next 24 and the last five. If the range of f32 is too small, an
//! additional f32 s scales the number by s⁸. The factors are powers of two, so nothing is rounded.

use bentray::gpu::Gpu;
use glam::{DVec3, Vec4};

use crate::support::probe::Probe;

/// U of f64.
pub const U64: f64 = 0.5 * f64::EPSILON;

/// `real` reads a row from [`split`]; `put_real` writes one for [`joined`]; `times` is exact if the result is normal.
pub const REALS: &str = "fn times(a: Real, s: f32) -> Real {
    let s4 = Real(s) * Real(s) * Real(s) * Real(s);
    return a * s4 * s4;
}

fn real(row: vec4f) -> Real {
    return times(Real(row.x) + Real(row.y) + Real(row.z), row.w);
}

fn put_real(k: u32, a: Real) {
    let high = f32(a);
    let middle = f32(a - Real(high));
    put(k, vec4f(high, middle, f32(a - Real(high) - Real(middle)), 1.0));
}

fn put_real3(k: u32, a: Real3) {
    put_real(k, a.x);
    put_real(k + 1u, a.y);
    put_real(k + 2u, a.z);
}
";

/// Returns the s for which s⁸ v is near 1.
pub fn scale_of(v: f64) -> f32 {
    if v == 0.0 || !v.is_finite() {
        return 1.0;
    }
    2.0_f32.powi(-(v.abs().log2() / 8.0).round().clamp(-126.0, 126.0) as i32)
}

/// Returns s⁸ v.
pub fn times(v: f64, s: f32) -> f64 {
    let s4 = f64::from(s).powi(4);
    v * s4 * s4
}

/// Returns an f64 as an input row.
pub fn split(v: f64) -> Vec4 {
    if v == 0.0 || !v.is_finite() {
        return Vec4::new(v as f32, 0.0_f32.copysign(v as f32), 0.0_f32.copysign(v as f32), 1.0);
    }
    let scale = scale_of(v);
    let near = times(v, scale);
    let high = near as f32;
    let middle = (near - f64::from(high)) as f32;
    let low = (near - f64::from(high) - f64::from(middle)) as f32;
    Vec4::new(high, middle, low, 1.0 / scale)
}

/// Returns the f64 of an output row.
pub fn joined(row: Vec4) -> f64 {
    let high = f64::from(row.x);
    if high.is_finite() { high + f64::from(row.y) + f64::from(row.z) } else { high }
}

/// Returns the vector of three output rows.
pub fn joined3(rows: &[Vec4]) -> DVec3 {
    DVec3::new(joined(rows[0]), joined(rows[1]), joined(rows[2]))
}

/// Returns the answers of the device, one f64 for each row that the body writes.
pub fn answers<const I: usize, const O: usize>(
    probe: Probe,
    gpu: &Gpu,
    body: &str,
    inputs: &[[Vec4; I]],
) -> Vec<[f64; O]> {
    let rows = probe.stub(REALS).run::<I, O>(gpu, body, inputs);
    rows.iter().map(|rows| rows.map(joined)).collect()
}
