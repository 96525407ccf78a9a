//! The planes of an image in temporary files, for formats that store one plane after the other.
//!
//! Bands contain all planes of some rows, so that the planes can be put in order only when the image is complete. Until then each is in a
//! file without a name in the folder of the image, which the operating system removes with the process. Memory does not grow with the image.

use std::fs::File;
use std::io::{BufWriter, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use super::band::{ArrayKind, Rows, arrays};
use super::{FileSettings, OutputError, destination};
use crate::render::Band;

/// The arrays of an unfinished image.
pub(super) struct Planes {
    rows: Rows,
    arrays: Vec<Array>,
}

/// The values of an array of an image.
pub(super) struct Array {
    /// The name and the type.
    pub kind: ArrayKind,
    /// The width and height.
    pub size: [u32; 2],
    path: PathBuf,
    /// The values of each component, row by row from the top.
    components: Vec<BufWriter<File>>,
}

impl Planes {
    /// Creates the temporary files of an image at `path`.
    pub fn create(path: &Path, settings: &FileSettings) -> Result<Self, OutputError> {
        let size = settings.window.size;
        let array = |kind: ArrayKind| {
            let components = (0..kind.count).map(|_| temporary(path)).collect::<Result<_, _>>()?;
            Ok(Array { kind, size, path: path.to_owned(), components })
        };
        let arrays = arrays(settings).into_iter().map(array).collect::<Result<_, _>>()?;
        let rows = Rows::new(path.to_owned(), size, settings.alpha, settings.layers.clone());
        Ok(Self { rows, arrays })
    }

    /// Appends a band.
    pub fn write_band(&mut self, band: &Band) -> Result<(), OutputError> {
        self.rows.accept(band)?;
        for (array, planes) in self.arrays.iter_mut().zip(self.rows.bits(band)) {
            for (file, plane) in array.components.iter_mut().zip(planes) {
                file.write_all(bytemuck::cast_slice(plane))
                    .map_err(|cause| OutputError::Write { path: array.path.clone(), cause })?;
            }
        }
        Ok(())
    }

    /// Returns the arrays of the complete image: color, alpha if it has any, and the layers.
    pub fn complete(self) -> Result<Vec<Array>, OutputError> {
        self.rows.complete()?;
        Ok(self.arrays)
    }
}

impl Array {
    /// Returns the bits of a component in a row.
    pub fn row(&mut self, component: usize, y: u32) -> Result<Vec<u32>, OutputError> {
        let mut words = vec![0; self.size[0] as usize];
        let bytes: &mut [u8] = bytemuck::cast_slice_mut(&mut words);
        let at = u64::from(y) * bytes.len() as u64;
        let file = &mut self.components[component];
        let read = file.seek(SeekFrom::Start(at)).and_then(|_| file.get_mut().read_exact(bytes));
        read.map_err(|cause| OutputError::Read { path: self.path.clone(), cause })?;
        Ok(words)
    }
}

/// Creates a file without a name in the folder of the target.
fn temporary(path: &Path) -> Result<BufWriter<File>, OutputError> {
    let target = destination(path);
    let folder = target.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let created = tempfile::tempfile_in(folder);
    let failed = |cause| OutputError::Create { path: path.to_owned(), folder: folder.to_owned(), cause };
    Ok(BufWriter::new(created.map_err(failed)?))
}
