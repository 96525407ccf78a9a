//! Vectors with a bound on their rounding errors: every operation adds its largest error and passes on the errors of its
//! inputs.
//!
//! The bound is of first order in the unit of rounding, so [`Rough::bound`] adds one per cent.

use glam::DVec3;

use super::schemes::Vector;

/// A value, and a bound on its error if every operation rounds.
#[derive(Debug, Clone, Copy)]
pub struct Rough {
    pub value: DVec3,
    off: f64,
    /// The relative error of one rounding.
    unit: f64,
}

impl Rough {
    /// Returns an exact input.
    pub fn exact(value: DVec3, unit: f64) -> Self {
        Self { value, off: 0.0, unit }
    }

    /// Returns a bound on the difference between a value computed in this arithmetic and its f64 form, whose operations err by U₆₄.
    pub fn bound(&self) -> f64 {
        1.01 * self.off * (1.0 + 0.5 * f64::EPSILON / self.unit)
    }
}

impl Vector for Rough {
    fn plus(self, h: f64, terms: &[(f64, Self)]) -> Self {
        let sum = Self::sum(h, terms);
        let value = self.value + sum.value;
        Self { value, off: self.off + sum.off + self.unit * value.length(), ..self }
    }

    /// Returns h Σ a k. A factor is rounded once and its product once; n − 1 additions, in any order, each err by at most
    /// the sum of the sizes of the terms; h may be a quotient (h/9) and is another factor.
    fn sum(h: f64, terms: &[(f64, Self)]) -> Self {
        let unit = terms[0].1.unit;
        let size: f64 = terms.iter().map(|(a, k)| a.abs() * k.value.length()).sum();
        let carried: f64 = terms.iter().map(|(a, k)| a.abs() * k.off).sum();
        let value = DVec3::sum(h, &terms.iter().map(|(a, k)| (*a, k.value)).collect::<Vec<_>>());
        Self { value, off: h.abs() * (carried + (terms.len() + 3) as f64 * unit * size), unit }
    }
}

/// Returns [`super::schemes::path_bend`] with its errors.
pub fn rough_bend(p: [Rough; 2]) -> impl Fn(Rough) -> Rough {
    let [x, v] = p;
    let (r, speed) = (x.value.length(), v.value.length());
    let l = x.value.cross(v.value).length();
    // A component of x × v errs by 5 U |x| |v| (x − c, two products and their difference), so the vector by 9 U.
    let cross = r * v.off + speed * x.off + 9.0 * x.unit * r * speed;
    let (held, held_off) = (l * l, 2.0 * l * cross + cross * cross + 3.0 * x.unit * l * l);
    move |at| {
        let r = at.value.length();
        let value = -3.0 * held / r.powi(5) * at.value;
        // r occurs as its fifth power and once as x; powers, quotient and products err by 20 U.
        let own = value.length() * (6.0 * at.off / r + 20.0 * at.unit);
        Rough { value, off: 3.0 * held_off / r.powi(4) + own, ..at }
    }
}
