//! FITS files (Flexible Image Transport System, version 4.0), for astronomy.
//!
//! The primary image is the color, a cube of red, green and blue; every layer is an image extension with its name in `EXTNAME`, and a cube
//! if it has components. As in all of FITS, the first row is the bottom of the image. Floats have 32 bits, whole numbers 32 bits with a
//! sign. The keyword `SETTINGS` of the primary header contains all settings as JSON, by the long-string convention.
//!
//! In a scene with `[units]`, every header has world coordinates: an image of the sky in gnomonic projection, with north up and east to the
//! left, whose center has the coordinates (0°, 0°). `BUNIT` of lengths is the scene's unit of length.

use std::fs::File;
use std::io::{BufReader, Read};
use std::path::Path;

use fitsio_pure::Error as FitsError;
use fitsio_pure::block::BLOCK_SIZE;
use fitsio_pure::header::{Card, parse_header_blocks};
use fitsio_pure::image_writer::ImageWriter as HduWriter;
use fitsio_pure::value::Value;

use super::origin::{LENGTH, PIXEL, metadata_json, with_metadata_json};
use super::planes::{Array, Planes};
use super::{AtomicFile, FileSettings, ImageWriter, OutputError};
use crate::render::Band;

/// The keyword of the settings.
const SETTINGS: &str = "SETTINGS";
/// The largest size of a header that is read, in bytes.
const LONGEST_HEADER: u64 = 1 << 20;

/// A writer of a FITS file.
pub struct FitsWriter {
    planes: Planes,
    metadata: String,
    /// The keywords of world coordinates; empty if the scale of the scene is not known.
    coordinates: Vec<(&'static str, Value)>,
    /// The unit of length.
    length: Option<String>,
    file: AtomicFile,
}

impl FitsWriter {
    /// Starts a file at `path`; exposure, tone map and bit depth are only recorded.
    ///
    /// # Errors
    ///
    /// Returns an error if a file cannot be created ([`AtomicFile::create`]).
    pub fn create(path: &Path, settings: &FileSettings) -> Result<Self, OutputError> {
        let file = AtomicFile::create(path)?;
        let length = settings.said(LENGTH).map(str::to_owned);
        let (planes, metadata) = (Planes::create(path, settings)?, metadata_json(settings));
        Ok(Self { planes, metadata, coordinates: coordinates(settings), length, file })
    }
}

impl ImageWriter for FitsWriter {
    fn write_band(&mut self, band: &Band) -> Result<(), OutputError> {
        self.planes.write_band(band)
    }

    fn finish(self: Box<Self>) -> Result<(), OutputError> {
        let Self { planes, metadata, coordinates, length, file } = *self;
        let path = file.path().to_owned();
        let failed = |error| encode_error(&path, error);
        let mut file = file;
        for (i, mut array) in planes.complete()?.into_iter().enumerate() {
            let mut cards = vec![text("EXTNAME", &array.kind.name.to_ascii_uppercase()).map_err(failed)?];
            for (key, value) in &coordinates {
                cards.push(Card::new(key, value.clone()).map_err(failed)?);
            }
            if let Some(unit) = length.as_ref().filter(|_| array.kind.is_length) {
                cards.push(text("BUNIT", unit).map_err(failed)?);
            }
            if i == 0 {
                cards.push(text("CREATOR", concat!("bentray ", env!("CARGO_PKG_VERSION"))).map_err(failed)?);
                cards.push(text(SETTINGS, &metadata).map_err(failed)?);
            }
            file = write_image(&mut array, file, i == 0, &cards, failed)?;
        }
        file.finish()
    }
}

/// Returns the world coordinates of an image of the sky (FITS 4.0, section 8), if the angle of a pixel is known.
fn coordinates(settings: &FileSettings) -> Vec<(&'static str, Value)> {
    let angle = settings.said(PIXEL).and_then(|text| text.strip_suffix(" uas")?.parse::<f64>().ok());
    let Some(degrees) = angle.map(|angle| angle / 3.6e9) else { return Vec::new() };
    let ([width, height], window) = (settings.size.map(f64::from), settings.window);
    let [left, top] = window.origin.map(f64::from);
    let below = height - top - f64::from(window.size[1]);
    let word = |word: &str| Value::String(word.to_owned());
    vec![
        ("CTYPE1", word("RA---TAN")),
        ("CTYPE2", word("DEC--TAN")),
        ("CUNIT1", word("deg")),
        ("CUNIT2", word("deg")),
        ("CRVAL1", Value::Float(0.0)),
        ("CRVAL2", Value::Float(0.0)),
        // The center of the first pixel is at 1.
        ("CRPIX1", Value::Float(0.5 * (width + 1.0) - left)),
        ("CRPIX2", Value::Float(0.5 * (height + 1.0) - below)),
        ("CDELT1", Value::Float(-degrees)),
        ("CDELT2", Value::Float(degrees)),
    ]
}

/// Appends an array as an image, or as a cube of its components.
fn write_image(
    array: &mut Array,
    file: AtomicFile,
    is_primary: bool,
    cards: &[Card],
    failed: impl Fn(FitsError) -> OutputError,
) -> Result<AtomicFile, OutputError> {
    let [width, height] = array.size;
    let mut axes = vec![width as usize, height as usize];
    if array.kind.count > 1 {
        axes.push(array.kind.count);
    }
    let bits = if array.kind.is_whole { 32 } else { -32 };
    let start = if is_primary { HduWriter::primary } else { HduWriter::image_extension };
    let mut image = start(file, bits, &axes, cards).map_err(&failed)?;
    for component in 0..array.kind.count {
        for y in (0..height).rev() {
            let row = array.row(component, y)?;
            let written = if array.kind.is_whole {
                image.write_iter(row.iter().map(|bits| bits.cast_signed()))
            } else {
                image.write_iter(row.iter().map(|bits| f32::from_bits(*bits)))
            };
            written.map_err(&failed)?;
        }
    }
    image.finish().map_err(failed)
}

fn text(key: &str, value: &str) -> Result<Card, FitsError> {
    Card::new(key, Value::String(value.to_owned()))
}

fn encode_error(path: &Path, error: FitsError) -> OutputError {
    match error {
        FitsError::Io(cause) => OutputError::Write { path: path.to_owned(), cause },
        other => OutputError::Encode { path: path.to_owned(), problem: other.to_string() },
    }
}

/// Returns the settings of the FITS file at `path`; `None` if it was not written by this program.
pub(super) fn settings_of_fits(path: &Path) -> Result<Option<FileSettings>, OutputError> {
    let unreadable = |cause| OutputError::Read { path: path.to_owned(), cause };
    let file = File::open(path).map_err(unreadable)?;
    let mut head = Vec::new();
    BufReader::new(file).take(LONGEST_HEADER).read_to_end(&mut head).map_err(unreadable)?;
    head.truncate(head.len() / BLOCK_SIZE * BLOCK_SIZE);
    let Ok(cards) = parse_header_blocks(&head) else { return Ok(None) };
    let settings = cards.iter().find(|card| card.keyword_str() == SETTINGS);
    Ok(settings.and_then(|card| match &card.value {
        Some(Value::String(text)) => with_metadata_json(text),
        _ => None,
    }))
}
