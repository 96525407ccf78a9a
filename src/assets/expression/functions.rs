//! The functions of one number in formulas.

/// A function of one number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Function {
    /// √a, a ≥ 0.
    Sqrt,
    /// eᵃ.
    Exp,
    /// ln a, a > 0.
    Log,
    /// The sine of an angle in radians, up to a million.
    Sin,
    /// The cosine of an angle in radians, up to a million.
    Cos,
    /// The tangent of an angle in radians, up to a million.
    Tan,
    /// (eᵃ − e⁻ᵃ)/2.
    Sinh,
    /// (eᵃ + e⁻ᵃ)/2.
    Cosh,
    /// sinh/cosh.
    Tanh,
    /// The inverse tangent, in (−π/2, π/2).
    Atan,
    /// |a|.
    Abs,
    /// The sign: −1, 0 or 1; only derivatives contain it.
    Sign,
}

/// The largest angle with a sine; f32 cannot distinguish larger angles.
const LARGEST_ANGLE: f64 = 1e6;

impl Function {
    /// The functions that users can write, by name.
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

    /// Returns the name.
    #[must_use]
    pub fn name(self) -> &'static str {
        Self::WRITTEN.iter().find(|(_, function)| *function == self).map_or("sign", |(name, _)| name)
    }

    /// Returns the value; not finite where it does not exist.
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
