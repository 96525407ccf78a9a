//! A sampled index of refraction from an NRRD or raw file, interpolated by a Catmull–Rom spline.

use std::sync::Arc;

use glam::DVec3;

use super::{Kind, Medium, MediumProperties};
use crate::assets::SampledGrid;
use crate::document::keys;
use crate::model::{Row, grid, row};

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
    read: |table, _, files| Some(Arc::new(Grid(grid::samples(table, files, true)?))),
};

/// A sampled index of refraction.
#[derive(Debug, Clone, PartialEq)]
pub struct Grid(pub Arc<SampledGrid>);

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
