//! The reader of files of samples on a regular grid, which media and volumes share.

use std::sync::Arc;

use glam::DVec3;

use crate::assets::{Files, GridUse, RawGridLayout, SampledGrid, Stored};
use crate::document::reader::TableReader;
use crate::document::values::{array, not_zero, number, point, text, whole, word};

/// Reads `file`, and the metadata that the file does not contain; the samples of a refractive index must be above 0.
pub(super) fn samples(table: &TableReader, files: &mut Files, is_index: bool) -> Option<Arc<SampledGrid>> {
    let file = table.required_node("file", "\"index.nrrd\"");
    let (min, max) = (table.optional("min", point), table.optional("max", point));
    let scale = table.or("scale", 1.0, not_zero);
    let offset = table.or("offset", 0.0, number);
    let name = table.reader.accept(text(file?))?;
    let has_header = [".nrrd", ".nhdr"].iter().any(|end| name.to_lowercase().ends_with(end));
    let bare = if has_header { None } else { Some(bare(table)?) };
    if !corners_fit(table, min, max) {
        return None;
    }
    let corners = min.zip(max).map(<[DVec3; 2]>::from);
    if bare.is_some() && corners.is_none() {
        let help = "for example min = [-1, -1, -1] and max = [1, 1, 1], the positions of the first and the last sample";
        table.fault(&[], "missing keys `min` and `max`", help);
        return None;
    }
    files.grid(table.reader, file?, &GridUse { bare, corners, scale, offset, is_index })
}

fn bare(table: &TableReader) -> Option<RawGridLayout> {
    let side = whole(2..=1 << 20);
    let size = table.required("size", "[64, 64, 64]", array("three whole numbers, [nx, ny, nz]", side));
    let stored = table.required("type", "\"f32\"", word(Stored::NAMES));
    let little = table.or("endian", true, word(&[("little", true), ("big", false)]));
    Some(RawGridLayout { size: size?, stored: stored?, little })
}

/// Returns `true` if both corners are present and ordered, or if both are missing.
fn corners_fit(table: &TableReader, min: Option<DVec3>, max: Option<DVec3>) -> bool {
    if table.gives("min") != table.gives("max") {
        table.fault(&["min", "max"], "`min` and `max` must be given together", "");
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
