//! Samples on grids, which formulas of volumes use by name.

use std::sync::Arc;

use super::Volume;
use crate::assets::{Files, MOST_GRIDS, SampledGrid};
use crate::document::reader::TableReader;
use crate::document::{KeyReference, Node, Span, Value, key_rows};
use crate::model::{Binding, grid, row};

/// Returns the binding of the grids of all volumes; their samples follow one another in `volume_samples`.
#[must_use]
pub fn bindings(volumes: &[Volume]) -> Binding {
    let mut first = 0;
    let row = |grid: &Arc<SampledGrid>| {
        let [nx, ny, nz] = grid.size;
        let at = first;
        first += grid.samples.len() as u32;
        row! { origin: Vec3(grid.origin), cell: Vec3(grid.cell), size: Uint4([nx, ny, nz, at]) }
    };
    Binding::list("volume_grids", volumes.iter().flat_map(|volume| &volume.grids).map(row).collect())
}

/// Returns the reference rows.
pub(super) fn reference() -> Vec<KeyReference> {
    key_rows! {
        "volumes.grids" {
            file: "file" = "required",
                "samples, offset + scale · value: NRRD if the name ends in .nrrd or .nhdr, otherwise raw numbers, x fastest";
            min: "[x, y, z]" = "from the NRRD file, or required", "position of the first sample, in the coordinates of the formulas; with max";
            max: "[x, y, z]" = "from the NRRD file, or required", "position of the last sample";
            scale: "number other than 0" = "1", "see `file`";
            offset: "number" = "0", "see `file`";
            size: "[nx, ny, nz], 2 or more" = "required, unless the file is NRRD", "samples along x, y and z";
            type: "i8 | u8 | i16 | u16 | i32 | u32 | i64 | u64 | f32 | f64" = "required, unless the file is NRRD", "data type of a sample";
            endian: "little | big" = "little", "byte order of a sample, unless the file is NRRD";
        }
    }
}

/// Reads the grids, with their names.
pub(super) fn read<'a>(
    table: &TableReader<'_, 'a>,
    files: &mut Files,
) -> Option<Vec<(String, &'a Node, Arc<SampledGrid>)>> {
    let Some(node) = table.node("grids") else { return Some(Vec::new()) };
    let Value::Table(all) = &node.value else {
        table.reader.fault(node.expected("a table of tables"));
        return None;
    };
    if all.len() > MOST_GRIDS {
        let problem = format!("{} grids exceed the limit of {MOST_GRIDS}", all.len());
        table.reader.fault(node.fault(problem, "use several volumes"));
        return None;
    }
    if !table.gives("shape") {
        let help = "add shape = \"box\" with min and max, within the grid";
        table.reader.fault(node.fault("a grid covers a part of space, and this volume is all of it", help));
        return None;
    }
    let read = |(name, _, node): &'a (String, Span, Node)| {
        let own = table.reader.open("volumes.grids", node)?;
        let grid = grid::samples(&own, files, false);
        own.finish();
        Some((name.clone(), node, grid?))
    };
    all.iter().map(read).collect()
}
