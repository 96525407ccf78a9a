//! Creation of nodes: constants are evaluated, and additions of 0 and multiplications by 1 are omitted.
//!
//! *Practice.* This keeps derivatives readable, and without divisions that the function itself does not have: r² is a node,
//! and its derivative is 2x, where 2 r (x/r) would have no value at r = 0.

use super::Function;
use super::graph::{Graph, Id, Node};

/// The largest whole exponent that is expanded to products; larger ones use the logarithm.
const LARGEST_POWER: f64 = 64.0;

/// Returns `true` for a power of two, multiplication by which is exact.
fn is_exact(factor: f64) -> bool {
    let size = factor.abs();
    (1e-3..=1e3).contains(&size) && size.log2().fract() == 0.0
}

impl Graph {
    pub(super) fn constant(&mut self, value: f64) -> Id {
        // 0 and −0 are one node.
        self.make(Node::Number((value + 0.0).to_bits()))
    }

    /// Returns the node or, if all its operands are numbers and it has a value, the value.
    pub(super) fn folded(&mut self, node: Node) -> Id {
        let number = |id: Id| self.number(id);
        let both = |a: Id, b: Id| number(a).zip(number(b));
        let value = match node {
            Node::Sum(a, b) => both(a, b).map(|(a, b)| a + b),
            Node::Difference(a, b) => both(a, b).map(|(a, b)| a - b),
            Node::Product(a, b) => both(a, b).map(|(a, b)| a * b),
            Node::Quotient(a, b) => both(a, b).map(|(a, b)| a / b),
            Node::Min(a, b) => both(a, b).map(|(a, b)| a.min(b)),
            Node::Max(a, b) => both(a, b).map(|(a, b)| a.max(b)),
            Node::Negative(a) => number(a).map(|a| -a),
            Node::Power(a, k) => number(a).map(|a| a.powi(k)),
            Node::Call(function, a) => number(a).map(|a| function.of(a)),
            _ => None,
        };
        match value.filter(|value| value.is_finite()) {
            Some(value) => self.constant(value),
            None => self.make(node),
        }
    }

    pub(super) fn sum(&mut self, a: Id, b: Id) -> Id {
        match (self.node(a), self.node(b)) {
            _ if self.number(a) == Some(0.0) => b,
            _ if self.number(b) == Some(0.0) => a,
            (_, Node::Negative(b)) => self.difference(a, b),
            (Node::Negative(a), _) => self.difference(b, a),
            _ => self.folded(Node::Sum(a, b)),
        }
    }

    pub(super) fn difference(&mut self, a: Id, b: Id) -> Id {
        match self.node(b) {
            _ if self.number(b) == Some(0.0) => a,
            _ if self.number(a) == Some(0.0) => self.negative(b),
            _ if a == b => self.constant(0.0),
            Node::Negative(b) => self.sum(a, b),
            _ => self.folded(Node::Difference(a, b)),
        }
    }

    pub(super) fn negative(&mut self, a: Id) -> Id {
        match self.node(a) {
            Node::Negative(a) => a,
            Node::Difference(a, b) => self.difference(b, a),
            Node::Product(a, b) if self.number(a).is_some() => {
                let a = self.negative(a);
                self.product(a, b)
            }
            _ => self.folded(Node::Negative(a)),
        }
    }

    pub(super) fn product(&mut self, a: Id, b: Id) -> Id {
        match (self.number(a), self.number(b)) {
            (Some(_), Some(_)) => return self.folded(Node::Product(a, b)),
            (Some(factor), None) => return self.scaled(factor, b),
            (None, Some(factor)) => return self.scaled(factor, a),
            (None, None) => {}
        }
        // Numbers and signs are collected in front.
        for (one, other) in [(a, b), (b, a)] {
            match self.node(one) {
                Node::Product(front, rest) if self.number(front).is_some() => {
                    let product = self.product(rest, other);
                    return self.product(front, product);
                }
                Node::Negative(rest) => {
                    let product = self.product(rest, other);
                    return self.negative(product);
                }
                Node::Distance => {
                    if let Node::Direction(axis) = self.node(other) {
                        return self.make(Node::Variable(axis));
                    }
                }
                Node::Power(base, k) if base == other && k > 0 => return self.power(base, k + 1),
                _ => {}
            }
        }
        match (self.node(a), self.node(b)) {
            (Node::Power(base, i), Node::Power(same, k)) if base == same && i.signum() == k.signum() => {
                self.power(base, i + k)
            }
            _ if a == b => self.power(a, 2),
            _ => self.make(Node::Product(a, b)),
        }
    }

    /// Returns the product of a number and a node that is not a number, with the number in front.
    fn scaled(&mut self, factor: f64, a: Id) -> Id {
        let front = self.constant(factor);
        if factor == 0.0 {
            return front;
        }
        if self.number(front) == Some(1.0) {
            return a;
        }
        match self.node(a) {
            Node::Product(number, rest) => match self.number(number).map(|number| factor * number) {
                Some(product) if product.is_finite() => self.scaled(product, rest),
                _ => self.make(Node::Product(front, a)),
            },
            Node::Negative(rest) => self.scaled(-factor, rest),
            // If the product is exact, the numbers in a sum are scaled separately.
            Node::Sum(b, c) if is_exact(factor) && (self.number(b).is_some() || self.number(c).is_some()) => {
                let [b, c] = [b, c].map(|part| self.product(front, part));
                self.sum(b, c)
            }
            _ if self.number(front) == Some(-1.0) => self.make(Node::Negative(a)),
            _ => self.make(Node::Product(front, a)),
        }
    }

    pub(super) fn quotient(&mut self, a: Id, b: Id) -> Id {
        match (self.node(a), self.node(b)) {
            _ if self.number(b) == Some(1.0) => a,
            _ if self.number(a) == Some(0.0) && self.number(b) != Some(0.0) => a,
            (Node::Negative(a), _) => {
                let quotient = self.quotient(a, b);
                self.negative(quotient)
            }
            (_, Node::Negative(b)) => {
                let quotient = self.quotient(a, b);
                self.negative(quotient)
            }
            (_, Node::Product(number, b)) if self.number(number).is_some_and(is_exact) => {
                let quotient = self.quotient(a, b);
                self.quotient(quotient, number)
            }
            (Node::Product(number, a), _) if self.number(number).is_some_and(is_exact) => {
                let quotient = self.quotient(a, b);
                self.product(number, quotient)
            }
            _ => match self.number(b).filter(|b| is_exact(*b)) {
                Some(number) if self.number(a).is_none() => self.scaled(1.0 / number, a),
                _ => self.folded(Node::Quotient(a, b)),
            },
        }
    }

    /// Returns aᵏ.
    pub(super) fn power(&mut self, a: Id, k: i32) -> Id {
        match (self.node(a), k) {
            (_, 0) => self.constant(1.0),
            (_, 1) => a,
            (Node::Distance, 2) => self.make(Node::Square),
            (Node::Distance, k) if k % 2 == 0 => {
                let square = self.make(Node::Square);
                self.power(square, k / 2)
            }
            // The exponents of nested powers must not overflow 32 bits.
            (Node::Power(b, i), k) if i.checked_mul(k).is_some_and(|ik| ik.abs() < 1 << 20) => self.power(b, i * k),
            (Node::Negative(b), k) => {
                let power = self.power(b, k);
                if k % 2 == 0 { power } else { self.negative(power) }
            }
            _ => self.folded(Node::Power(a, k)),
        }
    }

    /// Returns aᵇ; exponents that are neither whole numbers nor halves use e^(b log a).
    pub(super) fn raised(&mut self, a: Id, b: Id) -> Id {
        if let Some(exponent) = self.number(b) {
            if exponent.abs() <= LARGEST_POWER && exponent.fract() == 0.0 {
                return self.power(a, exponent as i32);
            }
            if exponent.abs() <= LARGEST_POWER && (2.0 * exponent).fract() == 0.0 {
                let root = self.call(Function::Sqrt, a);
                return self.power(root, (2.0 * exponent) as i32);
            }
        }
        let log = self.call(Function::Log, a);
        let product = self.product(b, log);
        self.call(Function::Exp, product)
    }

    pub(super) fn call(&mut self, function: Function, a: Id) -> Id {
        match (function, self.node(a)) {
            (Function::Sqrt, Node::Square) => self.make(Node::Distance),
            _ => self.folded(Node::Call(function, a)),
        }
    }
}
