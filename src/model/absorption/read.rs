//! The reader of `absorption`, which is a color or a table.

use glam::DVec3;

use super::{Absorption, Density, NoiseColoring, Texture, density_of};
use crate::assets::{Files, VolumeFormulas};
use crate::document::reader::TableReader;
use crate::document::values::{
    Parsed, array, color, direction, number, number_where, point, positive, text, whole, word,
};
use crate::document::{KeyReference, Node, Value, key_rows};

/// Returns the reference rows.
pub(crate) fn reference() -> Vec<KeyReference> {
    key_rows! {
        "absorption" {
            transmittance if "no coefficient and no texture": "[red, green, blue], or formulas" = "none",
                "fraction of light that remains after a unit length, 0 to 1: three numbers, or one or three formulas of x, y, z, r, rho, theta, phi and t";
            coefficient if "no transmittance and no texture": "number, formula, or three" = "none", "absorption coefficient σ = −ln transmittance, 0 or above, per unit length";
            texture if "no transmittance and no coefficient": "mix | wrapped | rainbow | ramp" = "none", "transmittance from fractal noise";
            low if r#"texture = "mix", or "wrapped""#: "[red, green, blue], 0 to 1" = "required", "color where the noise is lowest";
            high if r#"texture = "mix", or "wrapped""#: "[red, green, blue], 0 to 1" = "required", "color where the noise is highest";
            times if r#"texture = "wrapped""#: "number above 0" = "5", "number of repetitions of low to high";
            ramp if r#"texture = "ramp""#: "file" = "required", "image whose middle row contains the colors, from left to right";
            axis if r#"texture = "ramp""#: "[x, y, z]" = "none",
                "direction of waves of the ramp, perturbed by the noise, as in marble";
            turbulence if r#"texture = "ramp", with axis"#: "number" = "3", "strength of the perturbation";
            frequency if "texture": "number above 0" = "required", "lattice cells per unit length";
            octaves if "texture": "whole number, 1 to 8" = "4", "number of octaves of the noise";
            seed if "texture": "whole number" = "0", "seed of the noise";
            emission: "[red, green, blue]" = "[0, 0, 0]", "radiance that the medium adds, per unit length";
            center: "[x, y, z]" = "the object's, or [0, 0, 0]", "origin of x, y, z and r; scene units";
            tolerance: "number above 0 and below 1" = "0.001",
                "tolerance for the error of the optical depth, or of the light, of a piece of a path; pieces above it are divided";
        }
    }
}

/// Reads a filter from a node: a transmittance per unit length, or a table.
pub(crate) fn read(parent: &TableReader, node: &Node, center: DVec3, files: &mut Files) -> Option<Absorption> {
    if !matches!(node.value, Value::Table(_)) {
        return parent.reader.accept(part(node).map(Absorption::even));
    }
    let table = parent.reader.open("absorption", node)?;
    let usual = Absorption::even(DVec3::ONE);
    let small = number_where("a number above 0 and below 1", |x| x > 0.0 && x < 1.0);
    let center = table.or("center", center, point);
    let emission = table.or("emission", usual.emission, color);
    let tolerance = table.or("tolerance", usual.tolerance, small);
    let density = match table.one_of(&["transmittance", "coefficient", "texture"]) {
        Some(("transmittance", node)) => colors(&table, node),
        Some(("coefficient", node)) => densities(&table, node),
        Some(_) => texture(&table, files).map(Density::Texture),
        None => Some(usual.density),
    };
    table.finish();
    Some(Absorption { density: density?, emission, tolerance, center })
}

/// Reads a color with channels from 0 to 1.
fn part(node: &Node) -> Parsed<DVec3> {
    let color = color(node)?;
    if color.max_element() > 1.0 {
        let problem = format!("expected channels from 0 to 1, found {}", color.max_element());
        return Err(node.fault(
            problem,
            "give the fraction of light that remains after a unit length; for a medium that emits light, use \
             `emission`",
        ));
    }
    Ok(color)
}

fn colors(table: &TableReader, node: &Node) -> Option<Density> {
    if is_text(node) {
        return formulas(table, node, 0.0..=1.0).map(Density::Color);
    }
    table.reader.accept(part(node)).map(|color| Density::Even(density_of(color)))
}

fn densities(table: &TableReader, node: &Node) -> Option<Density> {
    if is_text(node) {
        return formulas(table, node, 0.0..=f64::INFINITY).map(Density::Formula);
    }
    let any = |node: &Node| number_where("a coefficient of 0 or above", |x| x >= 0.0)(node);
    let read = match node.value {
        Value::Array(_) => array("three coefficients, one per channel", any)(node).map(DVec3::from_array),
        _ => any(node).map(DVec3::splat),
    };
    table.reader.accept(read).map(Density::Even)
}

/// Returns `true` if the node contains formulas.
fn is_text(node: &Node) -> bool {
    match &node.value {
        Value::Text(_) => true,
        Value::Array(items) => items.iter().any(|item| matches!(item.value, Value::Text(_))),
        _ => false,
    }
}

/// Reads one formula for all channels or one for each; constant values must be within `range`.
fn formulas(table: &TableReader, node: &Node, range: std::ops::RangeInclusive<f64>) -> Option<VolumeFormulas> {
    let nodes: Vec<&Node> = match &node.value {
        Value::Array(items) if items.len() == 3 => items.iter().collect(),
        Value::Text(_) => vec![node],
        _ => {
            table.reader.fault(node.expected("one formula or three, in quotes"));
            return None;
        }
    };
    // All formulas are read before the first error returns, so that every error is reported.
    let read: Vec<Option<String>> = nodes.iter().map(|node| formula(table, node, &range)).collect();
    VolumeFormulas::of_medium(read.into_iter().collect::<Option<_>>()?).ok()
}

/// Returns the text of a valid formula.
fn formula(table: &TableReader, node: &Node, range: &std::ops::RangeInclusive<f64>) -> Option<String> {
    let written = table.reader.accept(text(node))?;
    match VolumeFormulas::of_medium(vec![written.to_owned()]).map_err(|(_, error)| error) {
        Ok(formula) => match formula.absorption_constant().filter(|value| !range.contains(value)) {
            Some(value) => {
                let problem = match range.end() {
                    end if end.is_finite() => format!("expected a fraction from 0 to 1, found {value}"),
                    _ => format!("expected a coefficient of 0 or above, found {value}"),
                };
                table.reader.fault_inside(node, 0..written.len(), problem, String::new());
                None
            }
            None => Some(written.to_owned()),
        },
        Err(error) => {
            table.reader.fault_inside(node, error.place, error.problem, error.help);
            None
        }
    }
}

fn texture(table: &TableReader, files: &mut Files) -> Option<Texture> {
    let kinds = &[("mix", 0), ("wrapped", 1), ("rainbow", 2), ("ramp", 3)];
    let kind = table.decide_required("texture", "\"mix\"", word(kinds));
    let frequency = table.required("frequency", "1.5", positive);
    let octaves = table.or("octaves", 4, whole(1..=8));
    let seed = table.or("seed", 0, whole(0..=u32::MAX));
    let look = match kind? {
        0 => NoiseColoring::Mix(two(table)?),
        1 => {
            let times = table.or("times", 5.0, positive);
            NoiseColoring::Wrapped(two(table)?, times)
        }
        2 => NoiseColoring::Rainbow,
        _ => ramp(table, files)?,
    };
    Some(Texture { look, frequency: frequency?, octaves, seed })
}

fn two(table: &TableReader) -> Option<[DVec3; 2]> {
    let low = table.required("low", "[0.2, 0.4, 0.9]", part);
    let high = table.required("high", "[1, 1, 1]", part);
    Some([low?, high?])
}

fn ramp(table: &TableReader, files: &mut Files) -> Option<NoiseColoring> {
    let node = table.required_node("ramp", "\"ramp.png\"")?;
    let axis = table.optional("axis", direction);
    let turbulence = axis.map(|_| table.or("turbulence", 3.0, number));
    let picture = files.picture(table.reader, node)?;
    Some(
        axis.zip(turbulence)
            .map_or(NoiseColoring::Ramp(picture), |(axis, part)| NoiseColoring::Marble(picture, axis, part)),
    )
}
