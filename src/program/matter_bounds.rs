//! The bounds of the matter in volumes along a piece of a path, as WGSL.

use std::fmt::Write as _;

use super::formula::body;
use super::interval::Bounds;
use crate::assets::{Id, Variable, VolumeFormulas};
use crate::scene::Volume;

/// The variables of emission and absorption other than coordinates, and their ranges.
const OTHERS: [(Variable, &str); 2] = [(VolumeFormulas::DENSITY, "density"), (VolumeFormulas::NU, "frequencies")];

/// Returns the bounds of a volume's density, emission and absorption.
pub(super) fn bounds(formulas: &VolumeFormulas) -> Bounds<'_> {
    Bounds::new(formulas.graph(), &formulas.light(), &OTHERS)
}

/// Generates the test whether a piece of a path may hide matter.
pub(super) fn hides(volumes: &[Volume], channels: usize) -> String {
    let mut text =
        "fn matter_hides(within: u32, piece: TransferPiece, size: Real) -> bool {\n    var hides = false;\n".to_owned();
    let mut functions = String::new();
    for (v, formulas) in volumes.iter().map(|volume| &volume.formulas).enumerate().filter(|(_, own)| own.varies()) {
        let bounds = bounds(formulas);
        let count = bounds.leaves.len();
        let ranges: Vec<_> = (0..count).map(|k| format!("seen_range({v}u, {k}u)")).collect();
        let _ = writeln!(text, "    if (within & {}u) != 0u {{", 1_u32 << v);
        let _ = writeln!(text, "        let ranges = array<Real2, {count}>({});", ranges.join(", "));
        let _ = writeln!(text, "        let density = volume_density_range_{v}(ranges);");
        let _ = writeln!(functions, "fn volume_density_range_{v}(ranges: array<Real2, {count}>) -> Real2 {{");
        let (lines, values) = bounds.body(&[formulas.density]);
        // Functions of constants are not evaluated in 64 bits.
        let is_constant = formulas.graph().number(formulas.density).is_some();
        let range = if is_constant { values.join("") } else { format!("max({}, Real2(0.0))", values.join("")) };
        let _ = writeln!(functions, "{lines}    return {range};\n}}\n");
        for (c, channel) in formulas.coefficients.iter().enumerate() {
            let (lines, values) = bounds.body(&[formulas.temperature.unwrap_or(channel.emission), channel.absorption]);
            let [emission, absorption] = &values[..] else { continue };
            let emission = match formulas.temperature {
                Some(_) => format!("interval_product({emission}, {absorption}).y"),
                None => most(formulas, channel.emission, emission),
            };
            let absorption = most(formulas, channel.absorption, absorption);
            let _ = writeln!(
                functions,
                "fn volume_most_{c}_{v}(ranges: array<Real2, {count}>, density: Real2, frequencies: Real2) -> Real2 {{\n\
                 {lines}    return Real2({emission}, {absorption});\n}}\n"
            );
            // Of powers of the frequency, only the factor is compared.
            let frequencies = if formulas.exponents().is_some() {
                "Real2(1.0)".to_owned()
            } else {
                format!("seen_frequencies({v}u)")
            };
            let _ = writeln!(text, "        let most_{c} = volume_most_{c}_{v}(ranges, density, {frequencies});");
            let all = if formulas.coefficients.len() == 1 { 0..channels } else { c..c + 1 };
            for k in all {
                let _ =
                    writeln!(text, "        hides = hides_light({v}u, {c}u, {k}u, most_{c}, piece, size) || hides;");
            }
        }
        text += "    }\n";
    }
    functions + &text + "    return hides;\n}\n\n"
}

/// Generates the record of the values at an end of a piece.
pub(super) fn seen_ends(volumes: &[Volume]) -> String {
    let mut text =
        "fn see_end(step: Stretch, within: u32, f: Real) {\n    let spot = stretch_spot(step, f);\n".to_owned();
    for (v, _) in volumes.iter().enumerate().filter(|(_, volume)| volume.formulas.varies()) {
        let _ = writeln!(
            text,
            "    if (within & {}u) != 0u {{\n        see_volume_{v}(volume_place_{v}(spot));\n    }}",
            1_u32 << v
        );
    }
    text + "}\n\n"
}

/// Returns the upper end of a range; naga does not evaluate components of constant vectors.
fn most(formulas: &VolumeFormulas, id: Id, range: &str) -> String {
    formulas.graph().number(id).map_or_else(|| format!("{range}.y"), |number| format!("Real({number:?})"))
}

/// Generates the record of the values at a point from which the bounds along a piece follow.
pub(super) fn recorded(v: usize, formulas: &VolumeFormulas) -> String {
    let leaves: Vec<Id> = bounds(formulas).leaves.into_keys().collect();
    let (lines, values) = body(formulas.graph(), &leaves, &VolumeFormulas::VARIABLES);
    let mut text = format!("\nfn see_volume_{v}(p: MatterPlace) {{\n{lines}");
    for (k, value) in values.iter().enumerate() {
        let _ = writeln!(text, "    see_value({v}u, {k}u, {value});");
    }
    let _ = writeln!(text, "    see_point({v}u);\n}}\n");
    text
}
