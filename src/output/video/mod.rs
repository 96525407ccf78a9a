//! Videos: sequences of images in one file.
//!
//! *Idea.* Frames are files first, so that a video can be resumed and its frames can be viewed. The video is encoded from them at the end,
//! which takes far less time. Every format has a file here, and [`KINDS`] lists them.
//!
//! *Practice.* One frame is in memory at a time, as 8-bit sRGB. This program writes GIF and animated PNG; `ffmpeg` encodes video, if it is
//! installed.

mod apng;
mod ffmpeg;
mod gif;

use std::path::{Path, PathBuf};

use ::image::{ImageDecoder, Rgba, RgbaImage};

use super::color::{linear_from_srgb, srgb_from_linear};
use super::{AtomicFile, OutputError};
use crate::progress::{Progress, Stage};

/// A video format.
struct VideoFormat {
    /// The file extension, in lower case.
    extension: &'static str,
    /// Returns why the format is unavailable here, if it is.
    problem: fn() -> Option<&'static str>,
    /// The largest number of pixels along a side.
    side: u32,
    /// The treatment of transparent pixels, if the format has no alpha.
    alpha: Option<&'static str>,
    write: fn(&mut AtomicFile, &mut Frames, &'static str) -> Result<(), OutputError>,
}

/// The treatment of transparent pixels by video.
const BLACK: Option<&str> = Some("transparent pixels are blended with black");

/// All formats.
const KINDS: [VideoFormat; 5] = [
    VideoFormat { extension: "mp4", problem: ffmpeg::problem, side: 16_384, alpha: BLACK, write: ffmpeg::write },
    VideoFormat { extension: "webm", problem: ffmpeg::problem, side: 65_535, alpha: BLACK, write: ffmpeg::write },
    VideoFormat { extension: "gif", problem: || None, side: 65_535, alpha: gif::ALPHA, write: gif::write },
    VideoFormat { extension: "png", problem: || None, side: u32::MAX, alpha: None, write: apng::write },
    VideoFormat { extension: "apng", problem: || None, side: u32::MAX, alpha: None, write: apng::write },
];

fn kind(path: &Path) -> Option<&'static VideoFormat> {
    let extension = path.extension()?.to_str()?.to_ascii_lowercase();
    KINDS.iter().find(|kind| kind.extension == extension)
}

/// Returns `true` if a video can have this name. A PNG with several images is also a video.
#[must_use]
pub fn is_film(path: &Path) -> bool {
    kind(path).is_some()
}

/// Returns the treatment of transparent pixels in a video of this name; `None` if it stores alpha.
#[must_use]
pub fn alpha_in_film(path: &Path) -> Option<&'static str> {
    kind(path)?.alpha
}

/// Returns `true` if an image's header declares alpha.
fn has_alpha(path: &Path) -> bool {
    let decoder = ::image::ImageReader::open(path).ok().and_then(|reader| reader.into_decoder().ok());
    decoder.is_some_and(|decoder| decoder.color_type().has_alpha())
}

/// Returns the treatment of transparent pixels in a video of these images; `None` if it stores alpha, or they have none.
#[must_use]
pub fn lost_alpha(path: &Path, frames: &[PathBuf]) -> Option<&'static str> {
    alpha_in_film(path).filter(|_| frames.iter().any(|frame| has_alpha(frame)))
}

/// Returns a pixel composited over black. Its color is not premultiplied.
fn before_black(pixel: Rgba<u8>) -> [u8; 3] {
    let [r, g, b, alpha] = pixel.0;
    let covered = f64::from(alpha) / 255.0;
    let shown = |x: u8| (srgb_from_linear(linear_from_srgb(f64::from(x) / 255.0) * covered) * 255.0).round() as u8;
    if alpha == u8::MAX { [r, g, b] } else { [r, g, b].map(shown) }
}

/// Checks that a video of images of this size can be written here.
///
/// # Errors
///
/// Returns [`OutputError::Setting`] if the extension is not that of a video, `ffmpeg` is required and not installed, or a side is too long
/// for the format.
pub fn check_film(path: &Path, size: [u32; 2]) -> Result<(), OutputError> {
    let setting = |problem: &str| OutputError::Setting { path: path.to_owned(), problem: problem.to_owned() };
    let kind = kind(path).ok_or_else(|| setting("the name of a video must end in .mp4, .webm, .gif, .png or .apng"))?;
    if let Some(problem) = (kind.problem)() {
        return Err(setting(problem));
    }
    match size.into_iter().max().filter(|side| *side > kind.side) {
        Some(side) => {
            let (extension, most) = (kind.extension, kind.side);
            let problem = format!(
                "a side of {side} pixels exceeds the limit of {most} for .{extension}: use .png, or a smaller size"
            );
            Err(setting(&problem))
        }
        None => Ok(()),
    }
}

/// Encodes a video from images of one size at this rate per second; reports the frames to `progress`.
///
/// # Errors
///
/// Returns [`OutputError::Part`] if a frame cannot be read or has another size than the first, the errors of [`check_film`], and an error
/// if the video cannot be encoded or written.
pub fn film(path: &Path, frames: &[PathBuf], rate: f64, progress: &Progress) -> Result<(), OutputError> {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let stage = progress.counted(format!("encoding {name}: frame"), frames.len());
    let mut frames = Frames::new(frames, rate, stage)?;
    check_film(path, frames.size)?;
    let mut file = AtomicFile::create(path)?;
    if let Some(kind) = kind(path) {
        (kind.write)(&mut file, &mut frames, kind.extension)?;
    }
    file.finish()
}

/// The images of a video, read in sequence.
struct Frames<'a> {
    paths: &'a [PathBuf],
    next: usize,
    /// The size of the first image, which all must have.
    size: [u32; 2],
    /// The number of frames per second.
    rate: f64,
    /// The stage that reports frames.
    stage: Stage,
}

impl<'a> Frames<'a> {
    fn new(paths: &'a [PathBuf], rate: f64, stage: Stage) -> Result<Self, OutputError> {
        let size = match paths.first() {
            Some(path) => {
                let size = ::image::image_dimensions(path).map_err(|error| unreadable(path, &error.to_string()))?;
                [size.0, size.1]
            }
            None => [0, 0],
        };
        Ok(Self { paths, next: 0, size, rate, stage })
    }

    fn count(&self) -> usize {
        self.paths.len()
    }

    /// Reads the next image, or returns `None` after the last.
    fn next(&mut self) -> Result<Option<RgbaImage>, OutputError> {
        self.stage.reach(self.next as f64);
        let Some(path) = self.paths.get(self.next) else { return Ok(None) };
        self.next += 1;
        let picture = ::image::open(path).map_err(|error| unreadable(path, &error.to_string()))?.into_rgba8();
        let (size, [width, height]) = (picture.dimensions(), self.size);
        if size != (width, height) {
            let (own, first) = (format!("{}x{}", size.0, size.1), self.paths[0].display());
            return Err(unreadable(path, &format!("it has {own} pixels, but {first} has {width}x{height}")));
        }
        Ok(Some(picture))
    }
}

fn unreadable(path: &Path, problem: &str) -> OutputError {
    OutputError::Part { path: path.to_owned(), problem: format!("cannot be a frame of a video: {problem}") }
}
