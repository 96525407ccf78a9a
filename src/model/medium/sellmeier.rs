//! The Sellmeier equation, n² = 1 + Σ B λ²/(λ² − C): n is constant over space and depends on wavelength.

use std::ops::RangeInclusive;
use std::sync::Arc;

use glam::{DVec3, DVec4};

use super::{Kind, Medium, MediumProperties};
use crate::document::Node;
use crate::document::keys;
use crate::document::reader::TableReader;
use crate::document::values::{Parsed, list, number, word};
use crate::model::{Row, STRAIGHT, row};

pub static KIND: Kind = Kind {
    name: "sellmeier",
    keys: keys! {
        glass: "BK7 | SF11 | fused-silica | water | diamond" = "none", "a common glass, instead of b and c";
        b: "up to 4 numbers" = "none", "Sellmeier coefficients B";
        c: "as many numbers" = "none", "Sellmeier coefficients C, in square micrometers";
    },
    read: |table, _, _| read(table).map(|medium| Arc::new(medium) as Arc<dyn Medium>),
};

/// The largest number of terms.
const TERMS: usize = 4;
/// The range of visible light, in nanometers.
pub const VISIBLE: RangeInclusive<f64> = 380.0..=730.0;
/// The helium d line, at which glasses are specified, in nanometers.
pub const D_LINE: f64 = 587.561_8;

/// B and C of common glasses, as in the refractiveindex.info database: N-BK7 and N-SF11 from Schott's catalog; silica (Malitson 1965,
/// checked to 6.7 µm by Tan 1998), water at 20 °C (Daimon and Masumura 2007) and diamond (Peter 1923, measured from 226 to 644 nm).
static GLASSES: [(&str, Sellmeier); 5] = [
    (
        "BK7",
        glass([1.039_612_12, 0.231_792_344, 1.010_469_45, 0.0], [0.006_000_698_67, 0.020_017_914_4, 103.560_653, 0.0]),
    ),
    (
        "SF11",
        glass([1.737_596_95, 0.313_747_346, 1.898_781_01, 0.0], [0.013_188_707, 0.062_306_814_2, 155.236_29, 0.0]),
    ),
    (
        "fused-silica",
        glass([0.696_166_3, 0.407_942_6, 0.897_479_4, 0.0], [0.004_679_148_3, 0.013_512_063, 97.934_003, 0.0]),
    ),
    (
        "water",
        glass(
            [0.568_402_756_5, 0.172_617_739_1, 0.020_861_895_78, 0.113_074_868_8],
            [0.005_101_829_712, 0.018_211_539_36, 0.026_207_222_93, 10.697_927_21],
        ),
    ),
    ("diamond", glass([0.3306, 4.3356, 0.0, 0.0], [0.030_625, 0.011_236, 0.0, 0.0])),
];

/// The ranges of validity of the glasses, in nanometers.
const RANGES: [RangeInclusive<f64>; 5] =
    [300.0..=2500.0, 370.0..=2500.0, 210.0..=6700.0, 182.0..=1129.0, 226.0..=760.0];

const fn glass(b: [f64; TERMS], c: [f64; TERMS]) -> Sellmeier {
    Sellmeier { b, c }
}

/// The Sellmeier equation, n² = 1 + Σ B λ²/(λ² − C).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sellmeier {
    /// The coefficients B.
    pub b: [f64; TERMS],
    /// The coefficients C, in square micrometers.
    pub c: [f64; TERMS],
}

impl Sellmeier {
    /// Returns n² at a wavelength in nanometers.
    fn square(&self, wavelength: f64) -> f64 {
        let square = square_micrometres(wavelength);
        let terms = self.b.iter().zip(self.c).map(|(b, c)| b * square / (square - c));
        1.0 + terms.sum::<f64>()
    }
}

/// Returns the square of a wavelength in nanometers, in square micrometers.
fn square_micrometres(wavelength: f64) -> f64 {
    (1e-3 * wavelength).powi(2)
}

fn terms(node: &Node) -> Parsed<Vec<f64>> {
    list("1 to 4 numbers", 1..=TERMS, number)(node)
}

fn read(table: &TableReader) -> Option<Sellmeier> {
    let (b, c) = (table.optional("b", terms), table.optional("c", terms));
    if let Some(glass) = table.optional("glass", word(&GLASSES)) {
        if table.gives("b") || table.gives("c") {
            table.fault(&["glass"], "`glass` defines B and C", "remove `b` and `c`, or `glass`");
        }
        return Some(glass);
    }
    let (Some(b), Some(c)) = (b, c) else {
        let is_complete = table.gives("glass") || (table.gives("b") && table.gives("c"));
        if !is_complete {
            table.fault(
                &[],
                "a Sellmeier medium requires a glass or coefficients",
                "name a glass, such as glass = \"BK7\", or give both `b` and `c`",
            );
        }
        return None;
    };
    if b.len() != c.len() {
        table.fault(
            &["c"],
            format!("`b` has {} numbers, and `c` has {}", b.len(), c.len()),
            "give the same number of values in both",
        );
        return None;
    }
    let filled = |values: &[f64]| std::array::from_fn(|k| values.get(k).copied().unwrap_or(0.0));
    let medium = Sellmeier { b: filled(&b), c: filled(&c) };
    let visible = square_micrometres(*VISIBLE.start())..=square_micrometres(*VISIBLE.end());
    if c.iter().any(|c| visible.contains(c)) {
        table.fault(
            &["c"],
            "a resonance is within the visible spectrum",
            "use values in square micrometers, outside the visible range of 0.1444 to 0.5329",
        );
        return None;
    }
    if !(medium.square(*VISIBLE.start()) > 0.0 && medium.square(*VISIBLE.end()) > 0.0) {
        table.fault(&["b"], "n² is not positive in visible light", "check the coefficients, for λ in micrometers");
        return None;
    }
    Some(medium)
}

impl Medium for Sellmeier {
    fn facts(&self) -> MediumProperties<'_> {
        MediumProperties {
            closed_form: Some(&STRAIGHT),
            is_dispersive: true,
            ..MediumProperties::of(&["medium/sellmeier"])
        }
    }

    fn values(&self, _: u32) -> Row {
        row! { b: Vec4(DVec4::from_array(self.b)), c: Vec4(DVec4::from_array(self.c)) }
    }

    /// Returns the index at the d line.
    fn index(&self, _: DVec3) -> Option<f64> {
        Some(self.square(D_LINE).sqrt())
    }

    /// A named glass is valid in the range of its data. Other coefficients are valid between the resonances around visible light.
    fn refuses_wavelength(&self, wavelength: f64) -> Option<String> {
        if let Some(((name, _), range)) = GLASSES.iter().zip(RANGES).find(|((_, medium), _)| medium == self) {
            let (from, to) = (range.start(), range.end());
            let problem = || format!("the formula of {name} is valid from {from} to {to} nm, not at {wavelength}");
            return (!range.contains(&wavelength)).then(problem);
        }
        let resonances = self.b.iter().zip(self.c).filter(|(b, c)| **b != 0.0 && *c > 0.0);
        let mut resonances = resonances.map(|(_, c)| 1e3 * c.sqrt());
        let visible = D_LINE.min(wavelength)..=D_LINE.max(wavelength);
        if let Some(at) = resonances.find(|at| visible.contains(at)) {
            return Some(format!(
                "the formula has a resonance at {at:.0} nm, between visible light and {wavelength} nm"
            ));
        }
        (self.square(wavelength) <= 0.0).then(|| format!("n² is not positive at {wavelength} nm"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Compares indices at the Fraunhofer lines F, d and C with catalogs.
    #[test]
    fn glasses_are_those_of_catalogues() {
        let lines = [486.132_7, D_LINE, 656.272_5];
        for (name, expected) in [
            ("BK7", [1.522_38, 1.516_80, 1.514_32]),
            ("SF11", [1.806_51, 1.784_72, 1.775_96]),
            ("fused-silica", [1.463_13, 1.458_46, 1.456_37]),
            ("water", [1.337_49, 1.333_40, 1.331_51]),
            ("diamond", [2.435_54, 2.417_49, 2.409_91]),
        ] {
            let glass = GLASSES.iter().find(|(known, _)| *known == name).unwrap().1;
            for (line, n) in lines.iter().zip(expected) {
                assert!((glass.square(*line).sqrt() - n).abs() < 6e-6, "{name} at {line} nm");
            }
        }
    }

    /// Compares indices in the infrared and ultraviolet with Schott's data sheet of N-BK7 and with Malitson's table.
    #[test]
    fn glasses_are_known_beyond_visible_light() {
        for (name, nm, n) in [
            ("BK7", 365.0, 1.536_27),
            ("BK7", 1060.0, 1.506_69),
            ("BK7", 1529.6, 1.500_91),
            ("BK7", 2325.4, 1.489_21),
            ("fused-silica", 365.015, 1.474_54),
            ("fused-silica", 2325.42, 1.432_93),
        ] {
            let glass = GLASSES.iter().find(|(known, _)| *known == name).unwrap().1;
            assert_eq!(glass.refuses_wavelength(nm), None);
            assert!((glass.square(nm).sqrt() - n).abs() < 6e-6, "{name} at {nm} nm: {}", glass.square(nm).sqrt());
        }
        for (name, nm) in [("BK7", 299.0), ("SF11", 365.0), ("water", 1130.0), ("fused-silica", 7000.0)] {
            let glass = GLASSES.iter().find(|(known, _)| *known == name).unwrap().1;
            assert!(glass.refuses_wavelength(nm).is_some_and(|why| why.contains(name)));
        }
    }
}
