//! Numbers with units, such as `"8.2 kpc"`, in a scene with a table `[units]`.
//!
//! *Theory.* With G = c = 1, a mass M is also the length GM/c² and the time GM/c³. One number therefore fixes the unit of length, of time and
//! of mass in a scene. An angle on the sky is a length too, if the distance of the scene is given: the length that subtends the angle at
//! this distance.
//!
//! *Practice.* A string that is a number with a unit becomes a [`Quantity`] before the document is read. Whether a key accepts it is
//! decided where the key is read, by the reader of its value, such as `length` in `values`.
//!
//! *Source.* Masses of the Sun, the Earth and Jupiter: nominal GM of IAU Resolution 2015 B3; parsec: IAU Resolution 2015 B2; G:
//! CODATA 2018.

use super::{Document, Node, Value};

/// The speed of light, in m/s.
pub const C: f64 = 299_792_458.0;
/// The gravitational constant, in m³/(kg s²).
const G: f64 = 6.674_30e-11;
/// GM of the Sun, in m³/s².
const GM_SUN: f64 = 1.327_124_4e20;
/// The astronomical unit, in m.
const AU: f64 = 149_597_870_700.0;
/// The parsec, in m.
const PARSEC: f64 = AU * 648_000.0 / std::f64::consts::PI;
/// The day and the Julian year, in s.
const DAY: f64 = 86_400.0;
const YEAR: f64 = 365.25 * DAY;
/// The second of arc, in radians.
pub const ARCSECOND: f64 = std::f64::consts::PI / 648_000.0;

/// The kind of thing that a unit measures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Dimension {
    /// Lengths, in meters.
    Length,
    /// Times, in seconds.
    Time,
    /// Masses, as GM in m³/s², which is known better than M.
    Mass,
    /// Angles of directions and rotations, in degrees, in which scenes give them.
    Angle,
    /// Angles on the sky, in radians: lengths, as seen from the distance of the scene.
    SkyAngle,
    /// Frequencies, in hertz.
    Frequency,
}

impl Dimension {
    /// Returns the name with its article.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Length => "a length",
            Self::Time => "a time",
            Self::Mass => "a mass",
            Self::Angle => "an angle",
            Self::SkyAngle => "an angle on the sky",
            Self::Frequency => "a frequency",
        }
    }

    /// Returns the names of the units.
    #[must_use]
    pub fn units(self) -> String {
        let own = UNITS.iter().filter(|(_, dimension, _)| *dimension == self);
        own.map(|(name, ..)| *name).collect::<Vec<_>>().join(", ")
    }
}

/// Every unit: name, dimension, and value in the unit that [`Dimension`] names.
const UNITS: &[(&str, Dimension, f64)] = &[
    ("nm", Dimension::Length, 1e-9),
    ("um", Dimension::Length, 1e-6),
    ("µm", Dimension::Length, 1e-6),
    ("mm", Dimension::Length, 1e-3),
    ("cm", Dimension::Length, 1e-2),
    ("m", Dimension::Length, 1.0),
    ("km", Dimension::Length, 1e3),
    ("Rsun", Dimension::Length, 6.957e8),
    ("au", Dimension::Length, AU),
    ("ly", Dimension::Length, C * YEAR),
    ("pc", Dimension::Length, PARSEC),
    ("kpc", Dimension::Length, 1e3 * PARSEC),
    ("Mpc", Dimension::Length, 1e6 * PARSEC),
    ("Gpc", Dimension::Length, 1e9 * PARSEC),
    ("ns", Dimension::Time, 1e-9),
    ("us", Dimension::Time, 1e-6),
    ("µs", Dimension::Time, 1e-6),
    ("ms", Dimension::Time, 1e-3),
    ("s", Dimension::Time, 1.0),
    ("min", Dimension::Time, 60.0),
    ("h", Dimension::Time, 3600.0),
    ("d", Dimension::Time, DAY),
    ("yr", Dimension::Time, YEAR),
    ("g", Dimension::Mass, 1e-3 * G),
    ("kg", Dimension::Mass, G),
    ("Mearth", Dimension::Mass, 3.986_004e14),
    ("Mjup", Dimension::Mass, 1.266_865_3e17),
    ("Msun", Dimension::Mass, GM_SUN),
    ("deg", Dimension::Angle, 1.0),
    ("mrad", Dimension::Angle, 0.18 / std::f64::consts::PI),
    ("rad", Dimension::Angle, 180.0 / std::f64::consts::PI),
    ("uas", Dimension::SkyAngle, 1e-6 * ARCSECOND),
    ("µas", Dimension::SkyAngle, 1e-6 * ARCSECOND),
    ("mas", Dimension::SkyAngle, 1e-3 * ARCSECOND),
    ("arcsec", Dimension::SkyAngle, ARCSECOND),
    ("arcmin", Dimension::SkyAngle, 60.0 * ARCSECOND),
    ("Hz", Dimension::Frequency, 1.0),
    ("MHz", Dimension::Frequency, 1e6),
    ("GHz", Dimension::Frequency, 1e9),
    ("THz", Dimension::Frequency, 1e12),
];

/// The scale of a scene: the table `[units]`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Units {
    /// The unit of length of the scene, in meters.
    pub length: Option<f64>,
    /// The distance from which the scene is seen, in meters.
    pub distance: Option<f64>,
}

impl Units {
    /// Returns the unit of time of the scene, in seconds.
    #[must_use]
    pub fn time(&self) -> Option<f64> {
        Some(self.length? / C)
    }

    /// Returns the angle that the scene's unit of length subtends at its distance, in radians.
    #[must_use]
    pub fn angle(&self) -> Option<f64> {
        Some(self.length? / self.distance?)
    }

    /// Returns a value in the units of the scene, or in degrees; `None` if they are not defined.
    fn scaled(&self, si: f64, dimension: Dimension) -> Option<f64> {
        match dimension {
            Dimension::Length => Some(si / self.length?),
            Dimension::Time => Some(si / self.time()?),
            Dimension::Mass => Some(si / (C * C) / self.length?),
            Dimension::SkyAngle => Some(si / self.angle()?),
            Dimension::Angle => Some(si),
            Dimension::Frequency => None,
        }
    }
}

/// A number with a unit.
#[derive(Debug, Clone, PartialEq)]
pub struct Quantity {
    /// The text in the file.
    pub text: String,
    /// The kind of unit.
    pub dimension: Dimension,
    /// The value in the unit that [`Dimension`] names.
    pub si: f64,
    /// The value in the units of the scene, or in degrees; `None` if `[units]` does not define it.
    pub value: Option<f64>,
}

impl Quantity {
    /// Parses a number with a unit, with or without a space between them; `None` if the text is anything else.
    #[must_use]
    pub fn parse(text: &str) -> Option<Self> {
        let name = text.trim_end().trim_start_matches(|sign: char| !sign.is_alphabetic() || "eE".contains(sign));
        // The exponent of a number may look like the beginning of a unit, but no unit begins with an e.
        let (_, dimension, unit) = UNITS.iter().find(|(own, ..)| *own == name.replace('μ', "µ"))?;
        let number: f64 = text.trim_end().strip_suffix(name)?.trim().parse().ok()?;
        Some(Self { text: text.to_owned(), dimension: *dimension, si: number * unit, value: None })
    }
}

impl Document {
    /// Converts all strings that are numbers with units, except in `[units]` itself.
    pub(crate) fn resolve_units(&mut self, units: &Units) {
        for (_, _, node) in self.root.iter_mut().filter(|(name, ..)| name != "units") {
            resolve(node, units);
        }
    }
}

fn resolve(node: &mut Node, units: &Units) {
    match &mut node.value {
        Value::Text(text) => {
            if let Some(read) = Quantity::parse(text) {
                let value = units.scaled(read.si, read.dimension);
                node.value = Value::Quantity(Quantity { value, ..read });
            }
        }
        Value::Array(items) => items.iter_mut().for_each(|item| resolve(item, units)),
        Value::Table(table) => table.iter_mut().for_each(|(.., node)| resolve(node, units)),
        _ => (),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_with_units_are_recognized() {
        let si = |text| Quantity::parse(text).map(|read| (read.dimension, read.si));
        assert_eq!(si("8.2 kpc"), Some((Dimension::Length, 8.2 * (1e3 * PARSEC))));
        assert_eq!(si("4.3e6 Msun"), Some((Dimension::Mass, 4.3e6 * GM_SUN)));
        assert_eq!(si("60uas"), si("60 μas"));
        assert_eq!(si("60 µas"), si("6e-2mas"));
        assert_eq!(si("-1E-3 km"), Some((Dimension::Length, -1.0)));
        for text in ["kpc", "8.2", "8.2 parsecs", "1 2 m", "a 2 m", "", "0.1px", "2 m + x", "1e5", "e5 m"] {
            assert_eq!(si(text), None, "{text}");
        }
    }

    #[test]
    fn a_mass_fixes_lengths_and_times() {
        let mass = Quantity::parse("1 Msun").unwrap();
        let units = Units { length: Some(mass.si / (C * C)), distance: Some(PARSEC) };
        assert!((units.length.unwrap() - 1476.625).abs() < 1e-3);
        assert_eq!(units.scaled(mass.si, Dimension::Mass), Some(1.0));
        assert!((units.time().unwrap() - 4.925_490_9e-6).abs() < 1e-12);
        // By the definition of the parsec, one astronomical unit at this distance subtends a second of arc.
        let second = units.scaled(ARCSECOND, Dimension::SkyAngle).unwrap();
        assert!((second / units.scaled(AU, Dimension::Length).unwrap() - 1.0).abs() < 1e-15);
    }
}
