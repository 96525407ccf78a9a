//! Charts of noise along a line (T §2.4): its octaves and their sum (Figs. 12 to 14), and the wrapped sum (Figs. 13 and 15).
//!
//! *Practice.* Along an axis of the lattice the splines of the other two axes weight a single row, so that four points suffice. Shaders
//! have a separate implementation, `medium/fractal_noise`; a test compares both.

use crate::gpu::hashed;
use crate::output::plot::{Chart, Series};

/// The number of samples of a curve per cell of its finest octave.
const SAMPLES: u32 = 16;

/// Returns the random number in [-1, 1] at a point of the lattice's first axis: the PCG output function of mixed coordinates.
fn lattice(cell: i32, seed: u32) -> f64 {
    let mixed = cell.cast_unsigned().wrapping_mul(0x8da6_b343) ^ seed.wrapping_mul(0x9e37_79b1);
    f64::from(hashed(mixed) >> 8) / 8_388_607.5 - 1.0
}

/// Returns one octave at x, in units of cells: a Catmull–Rom spline through the lattice's points.
fn octave(x: f64, seed: u32) -> f64 {
    let cell = x.floor();
    let t = x - cell;
    let weights =
        [t * (t * (2.0 - t) - 1.0), t * t * (3.0 * t - 5.0) + 2.0, t * (t * (4.0 - 3.0 * t) + 1.0), t * t * (t - 1.0)];
    // Charts have at most some thousands of cells.
    (-1..).zip(weights).map(|(next, weight)| 0.5 * weight * lattice(cell as i32 + next, seed)).sum()
}

/// Returns Σ 2⁻ʲ noise(2ʲ x) over `octaves` (T Eq. 10), with x in cells of the first.
#[must_use]
pub fn noise_sum(x: f64, octaves: u32, seed: u32) -> f64 {
    (0..octaves).map(|j| noise_term(x, j, seed)).sum()
}

fn noise_term(x: f64, j: u32, seed: u32) -> f64 {
    let scale = f64::from(1_u32 << j);
    octave(scale * x, seed) / scale
}

/// Returns the octaves of noise and their sum along a line of `length` cells.
#[must_use]
pub fn noise_chart(octaves: u32, length: f64, seed: u32) -> Chart {
    let terms = (0..octaves).map(|j| (format!("octave {}", j + 1), j));
    let mut series: Vec<Series> =
        terms.map(|(name, j)| curve(name, length, j + 1, |x| noise_term(x, j, seed))).collect();
    if octaves > 1 {
        series.push(curve("sum".to_owned(), length, octaves, |x| noise_sum(x, octaves, seed)));
    }
    chart("Octaves of noise", "noise", series)
}

/// Returns the sum as a number u from 0 to 1, and the wrapped sum m u − ⌊m u⌋ with m = `times` (T §2.4.3).
#[must_use]
pub fn wrapped_chart(octaves: u32, length: f64, seed: u32, times: f64) -> Chart {
    let most = 2.0 - (1.0 - f64::from(octaves)).exp2();
    let share = |x: f64| (0.5 * noise_sum(x, octaves, seed) / most + 0.5).clamp(0.0, 1.0);
    let plain = curve("from 0 to 1".to_owned(), length, octaves, share);
    let wrapped = curve(format!("wrapped {times} times"), length, octaves, |x| (times * share(x)).fract());
    chart("Wrapped noise", "u", vec![plain, wrapped])
}

fn curve(name: String, length: f64, octaves: u32, value: impl Fn(f64) -> f64) -> Series {
    let samples = (length * f64::from(SAMPLES << (octaves - 1))).ceil() as u32;
    let places = (0..=samples).map(|i| length * f64::from(i) / f64::from(samples));
    Series { name, points: places.map(|x| [x, value(x)]).collect() }
}

fn chart(title: &str, y_label: &str, series: Vec<Series>) -> Chart {
    Chart::linear(title, ["cells of the first octave", y_label], series)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn octaves_go_through_their_lattice_and_halve() {
        for cell in -3_i32..4 {
            let x = f64::from(cell);
            assert!((octave(x, 7) - lattice(cell, 7)).abs() < 1e-15);
            assert!((octave(x - 1e-9, 7) - octave(x + 1e-9, 7)).abs() < 1e-7, "{cell}");
            assert!((noise_term(0.5 * x, 1, 7) - 0.5 * lattice(cell, 7)).abs() < 1e-15);
        }
        let chart = noise_chart(3, 5.0, 1);
        assert_eq!(chart.series.len(), 4);
        let sum: f64 = chart.series[..3].iter().map(|series| series.points.last().unwrap()[1]).sum();
        assert!((chart.series[3].points.last().unwrap()[1] - sum).abs() < 1e-15);
        let wrapped = wrapped_chart(4, 5.0, 1, 5.0);
        assert!(wrapped.series[1].points.iter().all(|[_, u]| (0.0..1.0).contains(u)));
    }
}
