//! HDF5 files, for the arrays of simulations and of large archives.
//!
//! The color, the alpha and every layer are datasets of the root group under their names, with the shape (height, width) or (height, width,
//! components) and 32 bits per value; their first row is the top of the image. The attribute `metadata` of the root group contains the
//! settings as JSON. The datasets are contiguous, so that bands go directly to their place in the file.

use std::path::Path;

use rust_hdf5::{H5Dataset, H5File, Hdf5Error};

use super::band::{ArrayKind, Rows, arrays};
use super::origin::{metadata_json, with_metadata_json};
use super::{AtomicFile, FileSettings, ImageWriter, OutputError};
use crate::render::Band;

/// The attribute of the root group that contains the settings.
const METADATA: &str = "metadata";

/// A writer of an HDF5 file.
pub struct Hdf5Writer {
    rows: Rows,
    /// The color, the alpha if there is one, and the layers.
    datasets: Vec<Dataset>,
    contents: H5File,
    file: AtomicFile,
}

struct Dataset {
    kind: ArrayKind,
    stored: H5Dataset,
}

impl Hdf5Writer {
    /// Starts a file at `path`; exposure, tone map and bit depth are only recorded.
    ///
    /// # Errors
    ///
    /// Returns an error if a file cannot be created ([`AtomicFile::create`]).
    pub fn create(path: &Path, settings: &FileSettings) -> Result<Self, OutputError> {
        let file = AtomicFile::create(path)?;
        let size = settings.window.size;
        let failed = |error| encode_error(path, error);
        let contents = H5File::create(file.temporary()).map_err(failed)?;
        let dataset = |kind| Dataset::create(&contents, kind, size).map_err(failed);
        let datasets = arrays(settings).into_iter().map(dataset).collect::<Result<_, _>>()?;
        contents.set_attr_string(METADATA, &metadata_json(settings)).map_err(failed)?;
        let rows = Rows::new(path.to_owned(), size, settings.alpha, settings.layers.clone());
        Ok(Self { rows, datasets, contents, file })
    }
}

impl Dataset {
    fn create(file: &H5File, kind: ArrayKind, [width, height]: [u32; 2]) -> Result<Self, Hdf5Error> {
        let shape = [height as usize, width as usize, kind.count];
        let shape = if kind.count > 1 { &shape[..] } else { &shape[..2] };
        let stored = if kind.is_whole {
            file.new_dataset::<u32>().shape(shape).create(kind.name)?
        } else {
            file.new_dataset::<f32>().shape(shape).create(kind.name)?
        };
        Ok(Self { kind, stored })
    }

    /// Writes rows from `first`, of which the components are given one after the other.
    fn write(&self, first: u32, planes: &[&[u32]]) -> Result<(), Hdf5Error> {
        let mut counts = self.stored.shape();
        let mut starts = vec![0; counts.len()];
        starts[0] = first as usize;
        counts[0] = planes[0].len() / counts[1];
        let values = (0..planes[0].len()).flat_map(|pixel| planes.iter().map(move |plane| plane[pixel]));
        if self.kind.is_whole {
            self.stored.write_slice(&starts, &counts, &values.collect::<Vec<u32>>())
        } else {
            self.stored.write_slice(&starts, &counts, &values.map(f32::from_bits).collect::<Vec<f32>>())
        }
    }
}

impl ImageWriter for Hdf5Writer {
    fn write_band(&mut self, band: &Band) -> Result<(), OutputError> {
        self.rows.accept(band)?;
        for (dataset, planes) in self.datasets.iter().zip(self.rows.bits(band)) {
            dataset.write(band.first_row, &planes).map_err(|error| encode_error(&self.rows.path, error))?;
        }
        Ok(())
    }

    fn finish(self: Box<Self>) -> Result<(), OutputError> {
        let Self { rows, datasets, contents, file } = *self;
        rows.complete()?;
        drop(datasets);
        contents.close_no_sync().map_err(|error| encode_error(&rows.path, error))?;
        file.finish()
    }
}

fn encode_error(path: &Path, error: Hdf5Error) -> OutputError {
    match error {
        Hdf5Error::Io(cause) => OutputError::Write { path: path.to_owned(), cause },
        other => OutputError::Encode { path: path.to_owned(), problem: other.to_string() },
    }
}

/// Returns the settings of the HDF5 file at `path`; `None` if it was not written by this program.
pub(super) fn settings_of_hdf5(path: &Path) -> Result<Option<FileSettings>, OutputError> {
    match H5File::open(path) {
        Ok(file) => Ok(file.attr_string(METADATA).ok().and_then(|text| with_metadata_json(&text))),
        Err(Hdf5Error::Io(cause)) => Err(OutputError::Read { path: path.to_owned(), cause }),
        Err(_) => Ok(None),
    }
}
