//! Media that the user gives in full: formulas and grids of samples.

use super::files::Files;
use super::media::Surroundings;
use crate::scene::document::Node;
use crate::scene::document::reader::TableReader;
use crate::scene::document::values::{array, not_zero, number, positive, text, vector, whole, word};
use crate::scene::grid::{Bare, Stored, Use};
use crate::scene::{Formula, Medium};
use glam::DVec3;

/// `n`, a formula.
pub fn expression(table: &TableReader, around: Surroundings) -> Option<Medium> {
    let center = table.or("center", around.center, vector);
    let scale = table.or("scale", around.radius.unwrap_or(1.0), positive);
    let node = table.required_node("n", "\"1 + 0.1 * exp(-r^2)\"")?;
    Some(Medium::Expression { center, scale, n: formula(table, node)? })
}

fn formula(table: &TableReader, node: &Node) -> Option<Formula> {
    let reader = table.reader;
    let Ok(written) = text(node) else {
        reader.fault(node.fault("expected a formula, in quotes", "for one index everywhere use kind = \"constant\""));
        return None;
    };
    match Formula::parse(written) {
        Ok(formula) => {
            let nowhere = formula.constant().filter(|n| *n <= 0.0);
            if let Some(n) = nowhere {
                let problem = format!("expected an index above 0, found {n}");
                reader.fault_inside(node, 0..written.len(), problem, String::new());
            }
            nowhere.is_none().then_some(formula)
        }
        Err(error) => {
            reader.fault_inside(node, error.place, error.problem, error.help);
            None
        }
    }
}

/// `file`, and what it does not say itself.
pub fn grid(table: &TableReader, files: &mut Files) -> Option<Medium> {
    let file = table.required_node("file", "\"index.nrrd\"");
    let (min, max) = (table.optional("min", vector), table.optional("max", vector));
    let scale = table.or("scale", 1.0, not_zero);
    let offset = table.or("offset", 0.0, number);
    let name = table.reader.accept(text(file?))?;
    let has_header = name.to_lowercase().ends_with(".nrrd");
    let bare = if has_header { None } else { Some(bare(table)?) };
    if !corners_fit(table, min, max) {
        return None;
    }
    let corners = min.zip(max).map(<[DVec3; 2]>::from);
    if bare.is_some() && corners.is_none() {
        let help = "for example min = [-1, -1, -1] and max = [1, 1, 1]: where the first and the last sample are";
        table.fault(&[], "missing keys `min` and `max`", help);
        return None;
    }
    files.grid(table.reader, file?, &Use { bare, corners, scale, offset }).map(Medium::Grid)
}

fn bare(table: &TableReader) -> Option<Bare> {
    let side = whole(2..=1 << 20);
    let size = table.required("size", "[64, 64, 64]", array("three whole numbers, [nx, ny, nz]", side));
    let stored = table.required("type", "\"f32\"", word(Stored::NAMES, &[]));
    let little = table.or("endian", true, word(&[("little", true), ("big", false)], &[]));
    Some(Bare { size: size?, stored: stored?, little })
}

/// Are both there, and in order, or neither?
fn corners_fit(table: &TableReader, min: Option<DVec3>, max: Option<DVec3>) -> bool {
    if table.gives("min") != table.gives("max") {
        table.fault(&["min", "max"], "`min` and `max` go together", "");
        return false;
    }
    let Some((min, max)) = min.zip(max) else {
        return !table.gives("min");
    };
    let fit = min.cmplt(max).all();
    if !fit {
        table.fault(&["max"], "`max` must be above `min` in x, y and z", "");
    }
    fit
}
