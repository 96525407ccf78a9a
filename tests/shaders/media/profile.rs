//! Layered air: the spline is computed by a dense system for all coefficients at once.

use std::sync::LazyLock;

use glam::DVec3;

use super::{Case, Want};

const ORIGIN: DVec3 = DVec3::new(0.5, -0.25, 1.0);
const UP: DVec3 = DVec3::new(0.0, 0.6, 0.8);
/// A cold layer over a hot one, with points at very different distances.
const POINTS: [[f64; 2]; 6] = [[-1.0, 1.25], [0.5, 1.1875], [0.75, 1.3125], [2.0, 1.375], [6.0, 1.0625], [6.5, 1.0]];

/// The coefficients of tⁱ of each piece, from the values at both its ends, and the continuity of two derivatives at inner points.
static PIECES: LazyLock<Vec<[f64; 4]>> = LazyLock::new(|| {
    let pieces = POINTS.len() - 1;
    let mut rows: Vec<Vec<f64>> = Vec::new();
    let mut row = |terms: &[(usize, [f64; 4])], right: f64| {
        let mut row = vec![0.0; 4 * pieces + 1];
        for (piece, factors) in terms {
            row[4 * piece..4 * piece + 4].copy_from_slice(factors);
        }
        row[4 * pieces] = right;
        rows.push(row);
    };
    for k in 0..pieces {
        let t = POINTS[k + 1][0] - POINTS[k][0];
        row(&[(k, [1.0, 0.0, 0.0, 0.0])], POINTS[k][1]);
        row(&[(k, [1.0, t, t * t, t.powi(3)])], POINTS[k + 1][1]);
        let bend = [0.0, 0.0, 2.0, 6.0 * t];
        if k + 1 == pieces {
            row(&[(k, bend)], 0.0);
            row(&[(0, [0.0, 0.0, 2.0, 0.0])], 0.0);
        } else {
            row(&[(k, [0.0, 1.0, 2.0 * t, 3.0 * t * t]), (k + 1, [0.0, -1.0, 0.0, 0.0])], 0.0);
            row(&[(k, bend), (k + 1, [0.0, 0.0, -2.0, 0.0])], 0.0);
        }
    }
    solved(rows).chunks(4).map(|c| [c[0], c[1], c[2], c[3]]).collect()
});

/// Solves a system by Gauss–Jordan elimination with pivoting.
fn solved(mut rows: Vec<Vec<f64>>) -> Vec<f64> {
    let count = rows.len();
    for k in 0..count {
        let pivot = (k..count).max_by(|a, b| rows[*a][k].abs().total_cmp(&rows[*b][k].abs())).unwrap();
        rows.swap(k, pivot);
        let lead: Vec<f64> = rows[k].iter().map(|x| x / rows[k][k]).collect();
        for (i, row) in rows.iter_mut().enumerate() {
            let factor = row[k];
            row.iter_mut().zip(&lead).for_each(|(x, y)| *x -= if i == k { 0.0 } else { factor * y });
        }
        rows[k] = lead;
    }
    rows.iter().map(|row| row[count]).collect()
}

fn want(x: DVec3, u: f64) -> Want {
    let d = x - ORIGIN;
    let y = UP.dot(d);
    // This includes the rounding of the direction.
    let moved = 8.0 * u * d.length();
    let last = POINTS.len() - 1;
    let above = POINTS.iter().filter(|point| point[0] <= y).count();
    let k = above.clamp(1, last) - 1;
    let width = POINTS[k + 1][0] - POINTS[k][0];
    let outside = (POINTS[0][0] - y).max(y - POINTS[last][0]).max(0.0);
    let length = (width + outside, moved + 4.0 * u * (width + outside));
    if above == 0 || above > last {
        let n = POINTS[if above == 0 { 0 } else { last }][1];
        return Want { n: (n, 0.0), pull: (DVec3::ZERO, 0.0), length };
    }
    let [a, b, c, e] = PIECES[k];
    let t = y - POINTS[k][0];
    let n = a + b * t + c * t * t + e * t.powi(3);
    let slope = b + 2.0 * c * t + 3.0 * e * t * t;
    // Coefficients round once, and each term once per factor; t moves with y.
    let sizes = [a, b * t, c * t * t, e * t.powi(3)].map(f64::abs).iter().sum::<f64>();
    let n_error = slope.abs() * moved + (2.0 * c + 6.0 * e * t).abs() * moved * moved + 8.0 * u * sizes;
    let slopes = [b, 2.0 * c * t, 3.0 * e * t * t].map(f64::abs).iter().sum::<f64>();
    let bent = ((2.0 * c + 6.0 * e * t).abs() + 6.0 * e.abs() * moved) * moved;
    let slope_error = bent + 10.0 * u * slopes;
    let pull_error = n * slope_error + slope.abs() * n_error + 4.0 * u * (n * slope).abs();
    Want { n: (n, n_error), pull: (n * slope * UP, pull_error), length }
}

#[test]
fn profile() {
    let case = Case {
        name: "profile",
        parts: &["medium/profile"],
        index: "{ kind = \"profile\", origin = [0.5, -0.25, 1], up = [0, 0.6, 0.8], \
                points = [[-1, 1.25], [0.5, 1.1875], [0.75, 1.3125], [2, 1.375], [6, 1.0625], [6.5, 1]] }",
        center: ORIGIN,
        reach: [1e-6, 30.0],
        regular: true,
        want,
        // The length depends on the piece, and the slope jumps at both ends.
        undecided: |x, off| POINTS.iter().any(|point| (UP.dot(x - ORIGIN) - point[0]).abs() <= off),
    };
    case.check();
    case.pull_is_the_slope(1e-5);
}
