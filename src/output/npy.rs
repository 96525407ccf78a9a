//! Files of `NumPy`: `.npz` with every plane of an image, or every column of a table, as an array; `.npy` with the color alone.
//!
//! An `.npz` is a ZIP archive of `.npy` files, here uncompressed, so that `numpy.load` reads them at the speed of the disk. The arrays have
//! the names of the layers, the shape (height, width) or (height, width, components), and 32 bits per value; their first row is the top of
//! the image. The member `metadata.json` contains the settings. The format of arrays is NEP 1 of the `NumPy` project, version 1.0.

use std::fs::File;
use std::io::{Read, Write};
use std::path::Path;

use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipArchive, ZipWriter};

use super::origin::{metadata_json, with_metadata_json};
use super::planes::{Array, Planes};
use super::{AtomicFile, FileSettings, ImageWriter, OutputError};
use crate::render::Band;

/// The member of the archive that contains the settings.
const METADATA: &str = "metadata.json";
/// The alignment of the values in an array's file.
const ALIGNMENT: usize = 64;

/// A writer of an `.npz`.
pub struct NpzWriter {
    planes: Planes,
    metadata: String,
    file: AtomicFile,
}

impl NpzWriter {
    /// Starts an archive at `path`; exposure, tone map and bit depth are only recorded.
    ///
    /// # Errors
    ///
    /// Returns an error if a file cannot be created ([`AtomicFile::create`]).
    pub fn create(path: &Path, settings: &FileSettings) -> Result<Self, OutputError> {
        let file = AtomicFile::create(path)?;
        Ok(Self { planes: Planes::create(path, settings)?, metadata: metadata_json(settings), file })
    }
}

impl ImageWriter for NpzWriter {
    fn write_band(&mut self, band: &Band) -> Result<(), OutputError> {
        self.planes.write_band(band)
    }

    fn finish(self: Box<Self>) -> Result<(), OutputError> {
        let Self { planes, metadata, file } = *self;
        let path = file.path().to_owned();
        let failed = |cause: std::io::Error| OutputError::Write { path: path.clone(), cause };
        let mut archive = ZipWriter::new(file);
        for mut array in planes.complete()? {
            let bytes = array.size.iter().fold(4 * array.kind.count as u64, |bytes, side| bytes * u64::from(*side));
            archive.start_file(format!("{}.npy", array.kind.name), stored(bytes)).map_err(|e| failed(e.into()))?;
            write_array(&mut array, &mut archive, failed)?;
        }
        archive.start_file(METADATA, stored(metadata.len() as u64)).map_err(|e| failed(e.into()))?;
        archive.write_all(metadata.as_bytes()).map_err(failed)?;
        archive.finish().map_err(|e| failed(e.into()))?.finish()
    }
}

/// A writer of an `.npy`.
pub struct NpyWriter {
    planes: Planes,
    file: AtomicFile,
}

impl NpyWriter {
    /// Starts an array at `path`, which contains the color; all other settings are ignored.
    ///
    /// # Errors
    ///
    /// Returns [`OutputError::Setting`] if there are layers or alpha, and an error if the file cannot be created.
    pub fn create(path: &Path, settings: &FileSettings) -> Result<Self, OutputError> {
        if !settings.layers.is_empty() || settings.alpha {
            let problem = "an .npy stores one array, the color; write an .npz for alpha and layers".to_owned();
            return Err(OutputError::Setting { path: path.to_owned(), problem });
        }
        let file = AtomicFile::create(path)?;
        Ok(Self { planes: Planes::create(path, settings)?, file })
    }
}

impl ImageWriter for NpyWriter {
    fn write_band(&mut self, band: &Band) -> Result<(), OutputError> {
        self.planes.write_band(band)
    }

    fn finish(self: Box<Self>) -> Result<(), OutputError> {
        let Self { planes, mut file } = *self;
        let path = file.path().to_owned();
        for mut array in planes.complete()? {
            write_array(&mut array, &mut file, |cause| OutputError::Write { path: path.clone(), cause })?;
        }
        file.finish()
    }
}

/// Returns the options of a member of this size, without the time of writing, so that identical images have identical bytes.
fn stored(bytes: u64) -> SimpleFileOptions {
    let is_large = bytes + ALIGNMENT as u64 * 4 > u64::from(u32::MAX);
    SimpleFileOptions::DEFAULT.compression_method(CompressionMethod::Stored).large_file(is_large)
}

/// Writes an array in the format of `NumPy`: pixel by pixel, with all components of a pixel side by side.
fn write_array(
    array: &mut Array,
    file: &mut impl Write,
    failed: impl Fn(std::io::Error) -> OutputError,
) -> Result<(), OutputError> {
    let kind = if array.kind.is_whole { "<u4" } else { "<f4" };
    let [width, height] = array.size.map(u64::from);
    let count = array.kind.count;
    let shape = [height, width, count as u64];
    let shape = if count > 1 { &shape[..] } else { &shape[..2] };
    file.write_all(&head(kind, shape)).map_err(&failed)?;
    for y in 0..array.size[1] {
        let rows = (0..count).map(|component| array.row(component, y)).collect::<Result<Vec<_>, _>>()?;
        let pixels = (0..array.size[0] as usize).flat_map(|x| rows.iter().map(move |row| row[x].to_le_bytes()));
        file.write_all(&pixels.flatten().collect::<Vec<u8>>()).map_err(&failed)?;
    }
    Ok(())
}

/// Returns the bytes before the values: the type and shape as a Python dictionary, padded with spaces.
fn head(kind: &str, shape: &[u64]) -> Vec<u8> {
    let sides: Vec<String> = shape.iter().map(u64::to_string).collect();
    let mut words = format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': ({},), }}", sides.join(", "));
    let magic = b"\x93NUMPY\x01\x00";
    let before = magic.len() + size_of::<u16>();
    let whole = (before + words.len() + 1).next_multiple_of(ALIGNMENT);
    words.push_str(&" ".repeat(whole - before - words.len() - 1));
    words.push('\n');
    [&magic[..], &(words.len() as u16).to_le_bytes(), words.as_bytes()].concat()
}

/// Returns the file of an array of one dimension, from the bytes of its values.
pub(super) fn array_file(kind: &str, count: usize, values: &[u8]) -> Vec<u8> {
    [&head(kind, &[count as u64]), values].concat()
}

/// Writes the files of arrays as an archive to `file`.
pub(super) fn write_archive(
    file: AtomicFile,
    arrays: impl Iterator<Item = (&'static str, Vec<u8>)>,
) -> Result<AtomicFile, OutputError> {
    let path = file.path().to_owned();
    let failed = |cause: std::io::Error| OutputError::Write { path: path.clone(), cause };
    let mut archive = ZipWriter::new(file);
    for (name, bytes) in arrays {
        archive.start_file(format!("{name}.npy"), stored(bytes.len() as u64)).map_err(|e| failed(e.into()))?;
        archive.write_all(&bytes).map_err(failed)?;
    }
    archive.finish().map_err(|e| failed(e.into()))
}

/// Returns the settings of the `.npz` at `path`; `None` if it was not written by this program.
pub(super) fn settings_of_npz(path: &Path) -> Result<Option<FileSettings>, OutputError> {
    let unreadable = |cause: std::io::Error| OutputError::Read { path: path.to_owned(), cause };
    let file = File::open(path).map_err(unreadable)?;
    let mut archive = ZipArchive::new(file).map_err(|e| unreadable(e.into()))?;
    let mut text = String::new();
    match archive.by_name(METADATA) {
        Ok(mut member) => member.read_to_string(&mut text).map_err(unreadable)?,
        Err(_) => return Ok(None),
    };
    Ok(with_metadata_json(&text))
}
