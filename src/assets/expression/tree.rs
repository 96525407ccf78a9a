//! Formulas as trees, as they are written.

use super::Function;
use super::variable::Variable;
use std::fmt::{self, Display as _};

/// A formula or a subexpression.
#[derive(Debug, Clone, PartialEq)]
pub enum Tree {
    /// A number, which is not negative: a minus sign is a separate node.
    Number(f64),
    /// A variable, r or pi.
    Name(Name),
    /// A user-defined name for a formula, with its index among these names.
    Term(String, usize),
    /// −a.
    Negative(Box<Tree>),
    /// a + b and so on.
    Binary(Operator, Box<Tree>, Box<Tree>),
    /// f(a).
    Call(Function, Box<Tree>),
    /// The smaller or the larger of two.
    Extremum(Extremum, Box<Tree>, Box<Tree>),
}

/// A name that is not a function.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Name {
    /// A variable, with its spelling.
    Variable(&'static str, Variable),
    /// √(x² + y² + z²).
    R,
    Pi,
}

impl Name {
    /// Returns the spelling.
    pub fn text(self) -> &'static str {
        match self {
            Self::Variable(text, _) => text,
            Self::R => "r",
            Self::Pi => "pi",
        }
    }
}

/// An operator with two operands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Operator {
    Plus,
    Minus,
    Times,
    Over,
    Power,
}

/// The function `min` or `max`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Extremum {
    Min,
    Max,
}

impl Extremum {
    /// Returns the spelling.
    pub fn name(self) -> &'static str {
        match self {
            Self::Min => "min",
            Self::Max => "max",
        }
    }
}

/// The precedences: sums, products, minus, powers, and expressions that never need parentheses.
const SUM: u8 = 1;
const PRODUCT: u8 = 2;
const MINUS: u8 = 3;
const POWER: u8 = 4;
const WHOLE: u8 = 5;

impl Tree {
    fn strength(&self) -> u8 {
        match self {
            Self::Binary(Operator::Plus | Operator::Minus, ..) => SUM,
            Self::Binary(Operator::Times | Operator::Over, ..) => PRODUCT,
            Self::Binary(Operator::Power, ..) => POWER,
            Self::Negative(_) => MINUS,
            Self::Number(_) | Self::Name(_) | Self::Term(..) | Self::Call(..) | Self::Extremum(..) => WHOLE,
        }
    }

    /// Writes the expression, in parentheses if its precedence is below `strength`.
    fn part(&self, strength: u8, f: &mut fmt::Formatter) -> fmt::Result {
        if self.strength() < strength { write!(f, "({self})") } else { self.fmt(f) }
    }
}

impl fmt::Display for Tree {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            // Short numbers are written without an exponent.
            Self::Number(value) if (1e-4..1e6).contains(value) => write!(f, "{value}"),
            Self::Number(value) => write!(f, "{value:?}"),
            Self::Name(name) => f.write_str(name.text()),
            Self::Term(name, _) => f.write_str(name),
            Self::Negative(a) => {
                f.write_str("-")?;
                a.part(MINUS, f)
            }
            Self::Binary(operator, a, b) => {
                // Sums and products associate to the left, powers to the right.
                let (left, sign, right) = match operator {
                    Operator::Plus => (SUM, " + ", PRODUCT),
                    Operator::Minus => (SUM, " - ", PRODUCT),
                    Operator::Times => (PRODUCT, " * ", MINUS),
                    Operator::Over => (PRODUCT, " / ", MINUS),
                    Operator::Power => (WHOLE, "^", MINUS),
                };
                a.part(left, f)?;
                f.write_str(sign)?;
                b.part(right, f)
            }
            Self::Call(function, a) => write!(f, "{}({a})", function.name()),
            Self::Extremum(extreme, a, b) => write!(f, "{}({a}, {b})", extreme.name()),
        }
    }
}
