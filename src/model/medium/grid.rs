//! A sampled index of refraction from an NRRD or raw file, interpolated by a Catmull–Rom spline.

use std::sync::Arc;

use glam::DVec3;

use super::{Kind, Medium, MediumProperties};
use crate::assets::{Files, GridUse, IndexGrid, RawGridLayout, Stored};
use crate::document::keys;
use crate::document::reader::TableReader;
use crate::document::values::{array, not_zero, number, point, text, whole, word};
use crate::model::{Row, row};

pub static KIND: Kind = Kind {
    name: "grid",
    keys: keys! {
        file: "file" = "required",
            "samples of the index, n = offset + scale · value, with Catmull–Rom interpolation: NRRD if the name ends in .nrrd or .nhdr, otherwise raw numbers, x fastest";
        min: "[x, y, z]" = "from the NRRD file, or required", "position of the first sample, in scene units; with max";
        max: "[x, y, z]" = "from the NRRD file, or required",
            "position of the last sample, in scene units; outside the grid, the index has its value at the border";
        scale: "number other than 0" = "1", "see `file`";
        offset: "number" = "0", "see `file`";
        size (", unless the file is NRRD"): "[nx, ny, nz], 2 or more" = "required", "samples along x, y and z";
        type (", unless the file is NRRD"): "i8 | u8 | i16 | u16 | i32 | u32 | i64 | u64 | f32 | f64" = "required", "data type of a sample";
        endian (", unless the file is NRRD"): "little | big" = "little", "byte order of a sample";
    },
    read: |table, _, files| Some(Arc::new(Grid(samples(table, files)?))),
};

/// Reads `file`, and the metadata that the file does not contain.
fn samples(table: &TableReader, files: &mut Files) -> Option<Arc<IndexGrid>> {
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
    files.grid(table.reader, file?, &GridUse { bare, corners, scale, offset })
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

/// A sampled index of refraction.
#[derive(Debug, Clone, PartialEq)]
pub struct Grid(pub Arc<IndexGrid>);

impl Medium for Grid {
    fn facts(&self) -> MediumProperties<'_> {
        MediumProperties {
            terms: 16,
            samples: &self.0.samples,
            ..MediumProperties::of(&["medium/grid", "medium/finite"])
        }
    }

    fn values(&self, first: u32) -> Row {
        let [nx, ny, nz] = self.0.size;
        row! { origin: Vec3(self.0.origin), cell: Vec3(self.0.cell), size: Uint4([nx, ny, nz, first]) }
    }

    fn index(&self, _: DVec3) -> Option<f64> {
        None
    }
}
