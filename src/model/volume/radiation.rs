//! The frequencies at which light is followed, and their units.

use crate::document::reader::TableReader;
use crate::document::values::{Parsed, list, number_where, positive, quantity, whole};
use crate::document::{Dimension, KeyReference, Node, Value, key_rows};

/// The largest number of frequencies that are followed along one path.
pub const MOST_FREQUENCIES: usize = 8;

/// 2h/c², in erg s³/cm².
const PLANCK: f64 = 2.0 * 6.626_070_15e-27 / (2.997_924_58e10 * 2.997_924_58e10);

/// The table `[radiation]`: light at given frequencies instead of colors.
#[derive(Debug, Clone, PartialEq)]
pub struct Radiation {
    /// The frequencies that the observer measures, in units of ν₀.
    pub frequencies: Vec<f64>,
    /// ν₀ in hertz, if the frequencies have units.
    pub reference: Option<f64>,
    /// The emission coefficient 1, in erg/(cm³ s Hz sr).
    pub emission: Option<f64>,
    /// The largest error of a piece of a path, relative to the light of its ray, if the scene gives it.
    pub own_tolerance: Option<f64>,
    /// The intensity that pictures show as white, in the units of the layer `intensity_0`.
    pub white: f64,
    /// The colors of pictures.
    pub show: Show,
}

/// The colors in which pictures show intensities.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Show {
    /// The first frequency, from black to white.
    Gray,
    /// The first frequency, from black over red and yellow to white.
    Heat,
    /// These frequencies as red, green and blue.
    Frequencies([usize; 3]),
}

impl Radiation {
    /// The default tolerance of images.
    const TOLERANCE: f64 = 1e-4;
    /// The default tolerances of numbers, in 32 and in 64 bits.
    const FINE_TOLERANCES: [f64; 2] = [1e-6, 1e-9];
    /// The tolerance of colors, of which an image shows 256 values.
    pub const COLOR_TOLERANCE: f64 = 1e-3;

    /// Returns the largest error of a piece of a path, relative to the light of its ray.
    #[must_use]
    pub fn tolerance(&self) -> f64 {
        self.own_tolerance.unwrap_or(Self::TOLERANCE)
    }

    /// Sets the tolerance for the light of single rays, unless the scene gives one.
    pub fn refine(&mut self, is_double: bool) {
        self.own_tolerance.get_or_insert(Self::FINE_TOLERANCES[usize::from(is_double)]);
    }

    /// Returns a frequency in hertz.
    #[must_use]
    pub fn hertz(&self, k: usize) -> Option<f64> {
        Some(self.reference? * self.frequencies[k])
    }

    /// Returns 2hν₀³/c², in erg/(cm² s Hz sr), if the frequencies have units.
    #[must_use]
    pub fn planck_unit(&self) -> Option<f64> {
        Some(PLANCK * self.reference?.powi(3))
    }

    /// Returns the intensity 1 in erg/(cm² s Hz sr), for this length of the scene's unit in meters.
    #[must_use]
    pub fn unit(&self, length: f64) -> Option<f64> {
        Some(self.emission? * 100.0 * length)
    }
}

/// Returns the reference rows.
pub(super) fn reference() -> Vec<KeyReference> {
    key_rows! {
        "radiation" {
            frequencies: "array of 1 to 8 strings or numbers" = "required",
                "frequencies that the observer measures, such as \"230 GHz\"; numbers are in units of ν₀";
            reference: "string" = "the first frequency", "ν₀, the frequency at which `nu` is 1 in formulas of volumes";
            emission: "number above 0" = "none",
                "emission coefficient 1 of the formulas, in erg/(cm³ s Hz sr): with [units], intensities and fluxes then have units";
            tolerance: "number above 0, below 1" = "0.0001; for `bentray trace` 1e-6, in 64 bits 1e-9", "largest error of a piece of a path, relative to the light of its ray";
            white: "number above 0" = "1", "intensity that pictures show as white, in the units of the layer `intensity_0`";
            show: "gray | heat | [red, green, blue]" = "gray", "colors of pictures: of the first frequency, or the indices of three frequencies";
        }
    }
}

/// A frequency in hertz, or in units of ν₀.
enum Frequency {
    Hertz(f64),
    Relative(f64),
}

fn frequency(node: &Node) -> Parsed<Frequency> {
    match &node.value {
        Value::Text(_) | Value::Quantity(_) => match quantity(Dimension::Frequency)(node)? {
            value if value > 0.0 => Ok(Frequency::Hertz(value)),
            value => Err(node.fault(format!("expected a frequency above 0, found {value} Hz"), "")),
        },
        _ => positive(node).map(Frequency::Relative),
    }
}

/// Reads `[radiation]`; returns `None` without it, and after an error.
pub(super) fn read(root: &TableReader) -> Option<Radiation> {
    let table = root.subtable("radiation", "radiation")?;
    let all =
        table.required("frequencies", "[\"230 GHz\"]", list("1 to 8 frequencies", 1..=MOST_FREQUENCIES, frequency));
    let reference = table.optional("reference", quantity(Dimension::Frequency));
    let emission = table.optional("emission", any_positive);
    let small = number_where("a number above 0 and below 1", |x| x > 0.0 && x < 1.0);
    let own_tolerance = table.optional("tolerance", small);
    let white = table.or("white", 1.0, positive);
    let count = all.as_ref().map_or(1, Vec::len);
    let show = table.or("show", Show::Gray, |node| show(node, count));
    let in_hertz = all.as_ref().and_then(|all| match all.first()? {
        Frequency::Hertz(value) => Some(reference.unwrap_or(*value)),
        Frequency::Relative(_) => reference,
    });
    let relative = |frequency: &Frequency| match (frequency, in_hertz) {
        (Frequency::Relative(value), _) => Some(*value),
        (Frequency::Hertz(value), Some(reference)) => Some(value / reference),
        (Frequency::Hertz(_), None) => None,
    };
    let were_read = all.is_some();
    let frequencies: Option<Vec<f64>> = all.and_then(|all| all.iter().map(relative).collect());
    if frequencies.is_none() && were_read {
        let problem = "frequencies with and without units cannot be combined";
        table.fault(&["frequencies"], problem, "give all of them units, or set `reference`");
    }
    table.finish();
    Some(Radiation { frequencies: frequencies?, reference: in_hertz, emission, own_tolerance, white, show })
}

/// Reads a number above 0, which is used on the host alone and may be very small.
fn any_positive(node: &Node) -> Parsed<f64> {
    match node.value {
        Value::Float(value) if value > 0.0 && value.is_finite() => Ok(value),
        _ => positive(node),
    }
}

fn show(node: &Node, count: usize) -> Parsed<Show> {
    match &node.value {
        Value::Text(word) if word == "gray" => Ok(Show::Gray),
        Value::Text(word) if word == "heat" => Ok(Show::Heat),
        Value::Array(_) => {
            let index = whole(0..=count as u32 - 1);
            let all = list("three indices of frequencies", 3..=3, index)(node)?;
            Ok(Show::Frequencies([all[0] as usize, all[1] as usize, all[2] as usize]))
        }
        _ => Err(node.expected("gray, heat, or three indices of frequencies")),
    }
}
