//! The variables of formulas.

/// A variable of a formula, by its index among the values at which the formula is evaluated. In a function of position the first three
/// are x, y and z, which define r and its direction.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Variable(pub u8);

impl Variable {
    /// x, y and z.
    pub const PLACE: [Self; 3] = [Self(0), Self(1), Self(2)];
    /// dx, dy, dz and dt.
    pub const DIFFERENTIALS: [Self; 4] = [Self(3), Self(4), Self(5), Self(6)];
    /// The time t in spacetime.
    pub const TIME: Self = Self(7);
    /// The side of a throat: 1 on the near side, −1 on the far side.
    pub const SIDE: Self = Self(8);
    /// The parameter of a curve.
    pub const PARAMETER: Self = Self(0);
}
