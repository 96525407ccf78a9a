//! The functions of one number that formulas have.

/// A function of one number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Function {
    /// √a, a ≥ 0.
    Sqrt,
    /// eᵃ.
    Exp,
    /// ln a, a > 0.
    Log,
    /// Of radians, to a million.
    Sin,
    /// Of radians, to a million.
    Cos,
    /// Of radians, to a million.
    Tan,
    /// (eᵃ − e⁻ᵃ)/2.
    Sinh,
    /// (eᵃ + e⁻ᵃ)/2.
    Cosh,
    /// sinh/cosh.
    Tanh,
    /// In (−π/2, π/2).
    Atan,
    /// |a|.
    Abs,
    /// −1, 0 or 1: only derivatives have it.
    Sign,
}

/// Angles beyond this have no sine: f32 could not tell them from others.
const LARGEST_ANGLE: f64 = 1e6;

impl Function {
    /// Those that can be written, by name.
    pub const WRITTEN: [(&str, Self); 11] = [
        ("sqrt", Self::Sqrt),
        ("exp", Self::Exp),
        ("log", Self::Log),
        ("sin", Self::Sin),
        ("cos", Self::Cos),
        ("tan", Self::Tan),
        ("sinh", Self::Sinh),
        ("cosh", Self::Cosh),
        ("tanh", Self::Tanh),
        ("atan", Self::Atan),
        ("abs", Self::Abs),
    ];

    /// The name.
    #[must_use]
    pub fn name(self) -> &'static str {
        Self::WRITTEN.iter().find(|(_, function)| *function == self).map_or("sign", |(name, _)| name)
    }

    /// Its value; not finite where it has none.
    #[must_use]
    pub fn of(self, a: f64) -> f64 {
        let angle = if a.abs() <= LARGEST_ANGLE { a } else { f64::NAN };
        match self {
            Self::Sqrt => a.sqrt(),
            Self::Exp => a.exp(),
            Self::Log => a.ln(),
            Self::Sin => angle.sin(),
            Self::Cos => angle.cos(),
            Self::Tan => angle.tan(),
            Self::Sinh => a.sinh(),
            Self::Cosh => a.cosh(),
            Self::Tanh => a.tanh(),
            Self::Atan => a.atan(),
            Self::Abs => a.abs(),
            Self::Sign if a == 0.0 => 0.0,
            Self::Sign => a.signum(),
        }
    }
}
