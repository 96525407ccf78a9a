//! Images: PNG, JPEG, EXR and HDR files as linear RGB.
//!
//! *Theory.* Light adds up only in linear units, and colors mix only in equal primaries, here Rec. 709. PNG and JPEG encode
//! numbers by a curve, sRGB by default; EXR and HDR are linear. The color information of a file is applied, or
//! [`Picture::notes`] report that it is not.
//!
//! *Practice.* The format is detected by content. Alpha is dropped, gray becomes RGB, and 16 bits hold both
//! depths of PNG without loss. A pixel takes 12 bytes of memory.

mod broken;
mod encoding;
mod exr;
mod hdr;
mod png;
mod primaries;

use std::fs::File;
use std::io::{BufReader, Read};
use std::path::Path;
use std::sync::Arc;

use image::codecs::jpeg::JpegDecoder;
use image::{DynamicImage, ImageDecoder, ImageFormat, ImageReader};

use crate::document::SceneError;
use crate::progress::{Stage, Watched};
use broken::broken;
pub(in crate::assets) use encoding::decode_srgb;
use encoding::{Encoding, convert};
pub(crate) use exr::unlikely as unlikely_exr;

/// An image in linear RGB.
#[derive(Debug, Clone, PartialEq)]
pub struct Picture {
    /// The width and height in pixels.
    pub size: [u32; 2],
    /// The pixels, in rows from the top, each from the left; all numbers are finite. Copies of a scene share them.
    pub pixels: Arc<Vec<[f32; 3]>>,
    /// The path of the file.
    pub name: String,
    /// Messages about color information that was not applied, or that changed the colors.
    pub notes: Vec<String>,
}

/// The result of a format's reader.
struct Decoded {
    pixels: Vec<[f32; 3]>,
    notes: Vec<String>,
}

impl Picture {
    /// Reads a PNG, JPEG, EXR or HDR file.
    ///
    /// # Errors
    ///
    /// Returns [`SceneError::Read`] if the file cannot be read, and [`SceneError::Picture`] if its format is not one of these, it cannot be
    /// decoded, or a pixel is not finite.
    pub fn load(path: &Path) -> Result<Self, SceneError> {
        Self::read(path, &Stage::unwatched())
    }

    /// Reads a file as [`load`](Self::load) does, and reports the bytes that are read to `stage`.
    pub(super) fn read(path: &Path, stage: &Stage) -> Result<Self, SceneError> {
        let unreadable = |source| SceneError::Read { path: path.to_owned(), source };
        let unusable = |problem: String| SceneError::Picture { path: path.to_owned(), problem };
        let bytes = std::fs::metadata(path).map_err(unreadable)?.len();
        let other = |kind| unusable(format!("the image is {kind}: convert it to PNG, JPEG, EXR or HDR"));
        let format = Format::of(&Self::start(path).map_err(unreadable)?).map_err(other)?;
        let size = format.size(path).map_err(unusable)?;
        if let Some(problem) = unlikely(size, bytes) {
            return Err(unusable(problem));
        }
        let Decoded { pixels, notes } = format.read(path, bytes, stage).map_err(unusable)?;
        let broken = |pixel: &[f32; 3]| pixel.iter().any(|x| !x.is_finite());
        if let Some(index) = pixels.iter().position(broken) {
            let (x, y) = (index % size[0] as usize, index / size[0] as usize);
            return Err(unusable(format!("the pixel in column {x}, row {y} (counted from 0, top left) is not finite")));
        }
        Ok(Self { size, pixels: Arc::new(pixels), name: path.display().to_string(), notes })
    }
}

impl Picture {
    /// Returns the usual extension of a file that begins with these bytes, or
    /// a description of the unsupported format, such as "of the format WebP".
    pub(crate) fn ending(start: &[u8]) -> Result<&'static str, String> {
        Format::of(start).map(|format| match format {
            Format::Png => "png",
            Format::Jpeg => "jpg",
            Format::Exr => "exr",
            Format::Hdr => "hdr",
        })
    }

    /// Returns the first bytes of a file, as many as [`ending`](Self::ending) uses.
    pub(crate) fn start(path: &Path) -> std::io::Result<Vec<u8>> {
        let mut start = Vec::new();
        File::open(path)?.take(32).read_to_end(&mut start)?;
        Ok(start)
    }

    /// Returns the memory that [`load`](Self::load) takes according to a file's header, in bytes; 0 if the header is implausible.
    #[must_use]
    pub fn bytes_of(path: &Path) -> u64 {
        let format = Self::start(path).ok().and_then(|start| Format::of(&start).ok());
        let Some([width, height]) = format.and_then(|format| format.size(path).ok()) else { return 0 };
        let is_likely = std::fs::metadata(path).is_ok_and(|file| unlikely([width, height], file.len()).is_none());
        if is_likely { u64::from(width) * u64::from(height) * BYTES } else { 0 }
    }

    /// Returns the memory that the image takes, in bytes.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        self.pixels.len() as u64 * BYTES
    }
}

/// The size of a pixel in bytes.
const BYTES: u64 = size_of::<[f32; 3]>() as u64;

/// A supported format.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Format {
    Png,
    Jpeg,
    Exr,
    Hdr,
}

impl Format {
    /// Detects the format of a file from its first bytes.
    fn of(start: &[u8]) -> Result<Self, String> {
        if start.starts_with(hdr::MAGIC) {
            return Ok(Self::Hdr);
        }
        if start.starts_with(exr::MAGIC) {
            return Ok(Self::Exr);
        }
        match image::guess_format(start) {
            Ok(ImageFormat::Png) => Ok(Self::Png),
            Ok(ImageFormat::Jpeg) => Ok(Self::Jpeg),
            _ => Err(kind(start)),
        }
    }

    fn size(self, path: &Path) -> Result<[u32; 2], String> {
        match self {
            Self::Hdr => hdr::size(path),
            Self::Exr => exr::size(path),
            Self::Png | Self::Jpeg => {
                let (width, height) =
                    self.reader(path, &Stage::unwatched())?.into_dimensions().map_err(|error| broken(&error))?;
                Ok([width, height])
            }
        }
    }

    fn read(self, path: &Path, bytes: u64, stage: &Stage) -> Result<Decoded, String> {
        let encoding = match self {
            Self::Hdr => return hdr::read(path, stage),
            Self::Exr => return exr::read_file(path, bytes, stage),
            Self::Png => png::encoding(path)?,
            Self::Jpeg => jpeg_encoding(path)?,
        };
        let mut reader = self.reader(path, stage)?;
        // By default, images over 512 MiB are rejected, but a sky may be larger.
        reader.no_limits();
        let image: DynamicImage = reader.decode().map_err(|error| broken(&error))?;
        let mut pixels = encoding.decode(image);
        let mut notes = encoding.notes;
        notes.extend(convert(&mut pixels, encoding.to_rec709));
        Ok(Decoded { pixels, notes })
    }

    /// Opens a file of integers.
    fn reader<'s>(self, path: &Path, stage: &'s Stage) -> Result<ImageReader<BufReader<Watched<'s, File>>>, String> {
        let file = File::open(path).map_err(|error| error.to_string())?;
        let mut reader = ImageReader::new(BufReader::new(Watched::new(file, stage)));
        reader.set_format(if self == Self::Jpeg { ImageFormat::Jpeg } else { ImageFormat::Png });
        Ok(reader)
    }
}

/// Returns a description of an unsupported file.
fn kind(start: &[u8]) -> String {
    let name = match image::guess_format(start) {
        _ if start.is_empty() => return "empty".to_owned(),
        _ if start.starts_with(b"\xabKTX ") => "KTX".to_owned(),
        _ if start.starts_with(b"8BPS") => "PSD".to_owned(),
        Ok(ImageFormat::WebP) => "WebP".to_owned(),
        Ok(format) => format.extensions_str().first().map_or_else(String::new, |name| name.to_uppercase()),
        Err(_) => return "in an unknown format".to_owned(),
    };
    format!("in the format {name}")
}

/// Reads the ICC profile of a JPEG, which is its only color information.
fn jpeg_encoding(path: &Path) -> Result<Encoding, String> {
    let file = File::open(path).map_err(|error| error.to_string())?;
    let mut decoder = JpegDecoder::new(BufReader::new(file)).map_err(|error| broken(&error))?;
    let profile = decoder.icc_profile().map_err(|error| broken(&error))?;
    Ok(profile.map_or_else(Encoding::default, |profile| Encoding::of_profile(&profile)))
}

/// The largest number of pixels of an image: 3 GiB of memory.
const MOST_PIXELS: u64 = 1 << 28;
/// The largest number of pixels per byte of a file, in any format: their best compression is near 1000.
const DENSEST: u64 = 4096;

/// Returns the reason why an image of this size cannot be in a file of `bytes` bytes, if any.
fn unlikely([width, height]: [u32; 2], bytes: u64) -> Option<String> {
    let pixels = u64::from(width) * u64::from(height);
    if pixels == 0 {
        Some("the image has no pixels".to_owned())
    } else if pixels / DENSEST > bytes {
        Some(format!(
            "the header declares {width}×{height} pixels, which do not fit into the {bytes} bytes of the file"
        ))
    } else if pixels > MOST_PIXELS {
        Some(format!(
            "the image has {width}×{height} = {pixels} pixels, and at most {MOST_PIXELS} are supported: reduce its size"
        ))
    } else {
        None
    }
}

#[cfg(test)]
mod tests {
    use image::{DynamicImage, Rgb, Rgb32FImage};

    use super::*;
    use crate::progress::Progress;

    #[test]
    fn every_format_reports_how_much_of_it_was_read() {
        let folder = tempfile::tempdir().unwrap();
        let image = DynamicImage::from(Rgb32FImage::from_fn(64, 96, |x, y| Rgb([x as f32, y as f32, 1.0])));
        for name in ["a.png", "a.jpg", "a.hdr", "a.exr"] {
            let path = folder.path().join(name);
            let is_float = name.ends_with("exr") || name.ends_with("hdr");
            let image = if is_float { image.clone() } else { image.to_rgb8().into() };
            image.save(&path).unwrap();
            let progress = Progress::watched();
            let stage = progress.measured("reading", std::fs::metadata(&path).unwrap().len() as f64);
            Picture::read(&path, &stage).unwrap();
            let done = progress.state().and_then(|state| state.done);
            assert!(done.is_some_and(|done| done > 0.9), "{name}: {done:?}");
        }
    }
}
