//! Intervals: the range of a formula's values while its variables are anywhere in their intervals.
//!
//! *Theory.* Every operation encloses all values that it can have for arguments in its intervals, rounded outwards (Moore 1966). The result
//! of an operation that is undefined somewhere, such as 1/t over 0, is unbounded.
//!
//! *Practice.* The functions of the standard library are assumed to be correct within two units in the last place.

use super::Function;
use super::graph::{Graph, Id, Node};
use super::variable::Variable;

/// All numbers from `lo` to `hi`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interval {
    /// The smallest number.
    pub lo: f64,
    /// The largest number.
    pub hi: f64,
}

/// The ranges of all nodes of a graph over intervals of its variables.
#[derive(Debug, Clone)]
pub struct Enclosure {
    values: Vec<Interval>,
    /// Whether there is no kink, such as the kink of |t| at 0, so that derivatives bound the change of the formula.
    pub smooth: bool,
}

impl Enclosure {
    /// Returns the range of a node.
    #[must_use]
    pub fn of(&self, id: Id) -> Interval {
        self.values[id.index()]
    }
}

impl Interval {
    /// All numbers.
    pub const ALL: Self = Self { lo: f64::NEG_INFINITY, hi: f64::INFINITY };

    /// Returns the interval of one number.
    #[must_use]
    pub fn at(value: f64) -> Self {
        if value.is_nan() { Self::ALL } else { Self { lo: value, hi: value } }
    }

    /// Returns the interval between two numbers, in either order.
    #[must_use]
    pub fn between(a: f64, b: f64) -> Self {
        if a.is_nan() || b.is_nan() { Self::ALL } else { Self { lo: a.min(b), hi: a.max(b) } }
    }

    /// Returns the interval widened by this number of units in the last place.
    fn rounded(self, units: u32) -> Self {
        if self.lo.is_nan() || self.hi.is_nan() {
            return Self::ALL;
        }
        (0..units).fold(self, |own, _| Self { lo: own.lo.next_down(), hi: own.hi.next_up() })
    }

    /// Returns `true` if the interval contains the number.
    #[must_use]
    pub fn holds(self, value: f64) -> bool {
        self.lo <= value && value <= self.hi
    }

    /// Returns `true` if both ends are finite.
    #[must_use]
    pub fn is_finite(self) -> bool {
        self.lo.is_finite() && self.hi.is_finite()
    }

    /// Returns the largest absolute value.
    #[must_use]
    pub fn magnitude(self) -> f64 {
        self.lo.abs().max(self.hi.abs())
    }

    /// Returns the intersection, which must not be empty.
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        Self { lo: self.lo.max(other.lo), hi: self.hi.min(other.hi) }
    }

    /// Returns the smallest interval that contains both.
    #[must_use]
    pub fn or(self, other: Self) -> Self {
        Self { lo: self.lo.min(other.lo), hi: self.hi.max(other.hi) }
    }

    /// Returns the range of a function of two numbers, from its values at the ends: correct if it is monotonic in both.
    fn of_ends(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        let all = [f(self.lo, other.lo), f(self.lo, other.hi), f(self.hi, other.lo), f(self.hi, other.hi)];
        if all.iter().any(|value| value.is_nan()) {
            return Self::ALL;
        }
        let (lo, hi) = all.into_iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), v| (lo.min(v), hi.max(v)));
        Self { lo, hi }.rounded(1)
    }

    /// Returns the range of a b.
    #[must_use]
    pub fn times(self, other: Self) -> Self {
        // 0 times an unbounded interval is 0, because the numbers in it are finite.
        self.of_ends(other, |a, b| if a == 0.0 || b == 0.0 { 0.0 } else { a * b })
    }

    /// Returns the range of a + b.
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        Self { lo: self.lo + other.lo, hi: self.hi + other.hi }.rounded(1)
    }

    fn minus(self, other: Self) -> Self {
        self.plus(other.negative())
    }

    fn negative(self) -> Self {
        Self { lo: -self.hi, hi: -self.lo }
    }

    fn over(self, other: Self) -> Self {
        if other.holds(0.0) { Self::ALL } else { self.of_ends(other, |a, b| a / b) }
    }

    fn power(self, k: i32) -> Self {
        if k < 0 {
            return Self::at(1.0).over(self.power(-k));
        }
        let ends = Self::between(self.lo.powi(k), self.hi.powi(k));
        let dips = k % 2 == 0 && self.holds(0.0);
        if dips { Self { lo: 0.0, ..ends }.rounded(2) } else { ends.rounded(2) }
    }

    /// Returns the range of an increasing function.
    fn rising(self, f: impl Fn(f64) -> f64) -> Self {
        Self::between(f(self.lo), f(self.hi)).rounded(2)
    }

    fn absolute(self) -> Self {
        let ends = Self::between(self.lo.abs(), self.hi.abs());
        if self.holds(0.0) { Self { lo: 0.0, ..ends } } else { ends }
    }

    /// Returns the range of a periodic function of an angle, with maxima at `crest` and whole turns from there.
    fn wave(self, f: impl Fn(f64) -> f64, crest: f64) -> Self {
        use std::f64::consts::{PI, TAU};
        if !(f(self.lo).is_finite() && f(self.hi).is_finite()) {
            return Self::ALL;
        }
        // This slack is larger than any rounding of the angle.
        let slack = 1e-9 * (1.0 + self.magnitude());
        let passes = |at: f64| {
            let next = at + TAU * ((self.lo - slack - at) / TAU).ceil();
            next <= self.hi + slack
        };
        let ends = Self::between(f(self.lo), f(self.hi)).rounded(2);
        let lo = if passes(crest + PI) { -1.0 } else { ends.lo.max(-1.0) };
        let hi = if passes(crest) { 1.0 } else { ends.hi.min(1.0) };
        Self { lo, hi }
    }

    fn of(self, function: Function) -> Self {
        use std::f64::consts::{FRAC_PI_2, PI};
        let f = |a: f64| function.of(a);
        match function {
            Function::Sqrt | Function::Log if self.lo < 0.0 => Self::ALL,
            Function::Sqrt | Function::Log | Function::Exp | Function::Sinh | Function::Tanh | Function::Atan => {
                self.rising(f)
            }
            Function::Cosh => self.absolute().rising(f),
            Function::Sin => self.wave(f, FRAC_PI_2),
            Function::Cos => self.wave(f, 0.0),
            Function::Tan => {
                let branch = |a: f64| ((a - FRAC_PI_2) / PI).floor();
                let slack = 1e-9 * (1.0 + self.magnitude());
                let same = branch(self.hi + slack) - branch(self.lo - slack) < 0.5;
                if same { self.rising(f) } else { Self::ALL }
            }
            Function::Abs => self.absolute(),
            Function::Sign => Self::between(f(self.lo), f(self.hi)),
        }
    }
}

impl Graph {
    /// Returns the ranges of all nodes over these intervals of the variables. In functions of position, r and its direction are unbounded.
    #[must_use]
    pub fn enclose(&self, variables: &[Interval]) -> Enclosure {
        let mut values: Vec<Interval> = Vec::with_capacity(self.nodes().len());
        let own = |variable: Variable| variables.get(usize::from(variable.0)).copied().unwrap_or(Interval::ALL);
        let mut smooth = true;
        for node in self.nodes() {
            let of = |id: Id| values[id.index()];
            let value = match *node {
                Node::Number(bits) => Interval::at(f64::from_bits(bits)),
                Node::Variable(variable) => own(variable),
                Node::Square | Node::Distance | Node::Direction(_) => Interval::ALL,
                Node::Sum(a, b) => of(a).plus(of(b)),
                Node::Difference(a, b) => of(a).minus(of(b)),
                // A square is not negative.
                Node::Product(a, b) if a == b => of(a).power(2),
                Node::Product(a, b) => of(a).times(of(b)),
                Node::Quotient(a, b) => of(a).over(of(b)),
                Node::Negative(a) => of(a).negative(),
                Node::Power(a, k) => of(a).power(k),
                Node::Call(function, a) => {
                    let turns = matches!(function, Function::Abs | Function::Sign);
                    smooth &= !(turns && of(a).lo < 0.0 && of(a).hi > 0.0);
                    of(a).of(function)
                }
                Node::Min(a, b) | Node::Max(a, b) => {
                    let (a, b) = (of(a), of(b));
                    smooth &= a.hi <= b.lo || b.hi <= a.lo;
                    if matches!(node, Node::Min(..)) {
                        Interval { lo: a.lo.min(b.lo), hi: a.hi.min(b.hi) }
                    } else {
                        Interval { lo: a.lo.max(b.lo), hi: a.hi.max(b.hi) }
                    }
                }
                Node::ProgramOptions([a, b, c, d]) => {
                    let (a, b) = (of(a), of(b));
                    smooth &= a.hi < b.lo || a.lo >= b.hi;
                    if a.hi < b.lo {
                        of(c)
                    } else if a.lo >= b.hi {
                        of(d)
                    } else {
                        of(c).or(of(d))
                    }
                }
            };
            values.push(value);
        }
        Enclosure { values, smooth }
    }
}
