//! What formulas are functions of.

/// What a formula is a function of, by its place among the values that it is evaluated for. In a function of place the first three are
/// x, y and z, and r and its direction are theirs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Variable(pub u8);

impl Variable {
    /// x, y and z.
    pub const PLACE: [Self; 3] = [Self(0), Self(1), Self(2)];
    /// dx, dy, dz and dt.
    pub const DIFFERENTIALS: [Self; 4] = [Self(3), Self(4), Self(5), Self(6)];
    /// t of a place in spacetime.
    pub const TIME: Self = Self(7);
    /// Which side of a throat a place is on: 1 on this one, −1 on the other.
    pub const SIDE: Self = Self(8);
    /// The parameter of a curve.
    pub const PARAMETER: Self = Self(0);
}
