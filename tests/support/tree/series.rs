//! Taylor series of paths through a Gaussian medium.
//!
//! *Theory.* With ρ = x − c and n² = w, x″ = ∇w/2 = −k w ρ and w′ = −k w (ρ·ρ)′, where k = 2b/R². The coefficients of ρ, of
//! q = ρ·ρ and of w follow from each other by the product rule. A piece ends where the last terms are still under 1e-17 of
//! the sizes.

use glam::DVec3;

use super::path::Point;

/// The highest power.
const ORDER: usize = 24;

/// A path as pieces, each made when it is first needed.
#[derive(Debug, Clone)]
pub struct Series {
    center: DVec3,
    k: f64,
    pieces: Vec<Piece>,
}

#[derive(Debug, Clone)]
struct Piece {
    /// The parameter at which it begins, and the change of the parameter for which it holds.
    start: f64,
    length: f64,
    /// The coefficients of ρ, in powers of the parameter.
    terms: Vec<DVec3>,
}

impl Series {
    /// Returns the path from `x` with the velocity `v`, |v| = n there.
    pub fn new(center: DVec3, x: DVec3, v: DVec3, k: f64) -> Self {
        let first = Piece::new(0.0, x - center, v, k);
        Self { center, k, pieces: vec![first] }
    }

    /// Returns the point at the parameter `s`.
    pub fn at(&mut self, s: f64) -> Point {
        loop {
            let last = &self.pieces[self.pieces.len() - 1];
            let end = last.start + last.length;
            if s <= end {
                break;
            }
            let (rho, v) = last.at(end);
            self.pieces.push(Piece::new(end, rho, v, self.k));
        }
        let after = self.pieces.partition_point(|piece| piece.start <= s);
        let (rho, v) = self.pieces[after.max(1) - 1].at(s);
        (self.center + rho, v.normalize())
    }

    /// Returns a part of a piece over which the path hardly turns.
    pub fn stride(&self) -> f64 {
        0.2 * self.pieces.iter().map(|piece| piece.length).fold(f64::INFINITY, f64::min)
    }

    /// Returns |x′| at the start.
    pub fn speed(&self) -> f64 {
        self.pieces[0].terms[1].length()
    }
}

impl Piece {
    fn new(start: f64, rho: DVec3, v: DVec3, k: f64) -> Self {
        let mut terms = vec![rho, v];
        // |v| = n, so the index is not needed.
        let mut w = vec![v.length_squared()];
        let mut q = vec![rho.length_squared()];
        for n in 0..ORDER - 1 {
            q.push((0..=n + 1).map(|i| terms[i].dot(terms[n + 1 - i])).sum());
            let force: DVec3 = (0..=n).map(|i| w[i] * terms[n - i]).sum();
            terms.push(-k * force / ((n + 1) * (n + 2)) as f64);
            let rate: f64 = (0..=n).map(|i| (i + 1) as f64 * q[i + 1] * w[n - i]).sum();
            w.push(-k * rate / (n + 1) as f64);
        }
        let size = rho.length() + 1.0 / k.abs().sqrt();
        let reach = |i: usize| (1e-17 * size / terms[i].length()).powf(1.0 / i as f64);
        Self { start, length: reach(ORDER).min(reach(ORDER - 1)), terms }
    }

    /// Returns ρ and its rate.
    fn at(&self, s: f64) -> (DVec3, DVec3) {
        let t = s - self.start;
        let powers = self.terms.iter().enumerate().rev();
        powers.fold((DVec3::ZERO, DVec3::ZERO), |(rho, v), (i, term)| {
            let v = if i > 0 { v * t + i as f64 * *term } else { v };
            (rho * t + *term, v)
        })
    }
}
