//! The formulas of a volume as written, and the places of their errors.

/// The formulas of a volume as written.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct VolumeTexts {
    /// The parameters: names for numbers.
    pub parameters: Vec<(String, f64)>,
    /// The names for samples on grids.
    pub grids: Vec<String>,
    /// The names for formulas of position; each formula may use the names before it.
    pub terms: Vec<(String, String)>,
    /// The density.
    pub density: String,
    /// The emission per unit length: one for all channels, or one for each of three.
    pub emission: Vec<String>,
    /// The absorption per unit length, likewise.
    pub absorption: Vec<String>,
    /// The temperature of black-body emission, in kelvins, instead of the emission.
    pub temperature: Option<String>,
    /// The formulas of the motion: none, one, or three components.
    pub flow: Vec<String>,
}

/// The text that contains an error.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum VolumeField {
    /// A name for a number.
    Parameter(usize),
    /// A name for samples on a grid.
    GridName(usize),
    /// A name for a formula.
    TermName(usize),
    /// A formula with a name.
    Term(usize),
    /// The density.
    Density,
    /// A formula of the emission.
    Emission(usize),
    /// A formula of the absorption.
    Absorption(usize),
    /// The temperature.
    Temperature,
    /// A formula of the motion.
    Flow(usize),
}
