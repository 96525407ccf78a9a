//! The output of the program: images, tables and plots.
//!
//! Every file is written completely or not at all ([`AtomicFile`]), and can be created before the computation of its contents, so that an
//! unwritable path is reported first. Image writers ([`open`], [`ImageWriter`]) receive bands of full-width rows from the top, also on
//! another thread ([`BackgroundWriter`]). They store one band and a compressed tail, so that memory grows with the band and not with the
//! image. A PNG stores display colors ([`png`]); an EXR stores every plane exactly ([`exr`]), also of a part of an image, and [`merge()`]
//! merges parts. The same planes are written as arrays for `NumPy` ([`npy`]), for
//! astronomy ([`fits`]) and for archives ([`hdf5`]). Rays are CSV ([`csv`]), results are CSV or arrays ([`table`]), plots are SVG or PNG ([`plot`]), and a page of HTML shows them next to their tables
//! ([`report`]). Identical input gives identical bytes.

pub mod atomic;
mod background;
pub mod band;
pub mod color;
pub mod csv;
pub mod error;
pub mod exr;
pub mod fits;
mod glare;
pub mod hdf5;
pub mod lens_map;
pub mod merge;
pub mod npy;
pub mod origin;
mod part;
mod planes;
pub mod plot;
pub mod png;
pub mod report;
mod said;
pub mod table;
#[cfg(test)]
mod tests;
mod video;
mod whole;

use std::path::Path;

pub use atomic::{AtomicFile, abandon_unfinished, destination};
pub use background::BackgroundWriter;
pub use error::OutputError;
pub use merge::merge;
pub use said::{said, settings_of};
pub use video::{alpha_in_film, check_film, film, is_film, lost_alpha};
pub use whole::picture;

use crate::program::Layer;
use crate::render::{Band, Rendering, Window};
use crate::scene::{Scene, Tonemap};

/// The settings of an image file.
#[derive(Debug, Clone, PartialEq)]
pub struct FileSettings {
    /// The width and height of the whole image in pixels, neither zero.
    pub size: [u32; 2],
    /// The part in the file: a PNG does not store its position, an EXR stores it as the data window.
    pub window: Window,
    /// The exposure in stops: colors are multiplied by two to this power (PNG only).
    pub exposure: f64,
    /// The tone map, which brings bright colors into range (PNG only).
    pub tonemap: Tonemap,
    /// The bits per channel, 8 or 16 (PNG only).
    pub bits: u8,
    /// The fraction of light that the glare of a lens spreads (PNG only).
    pub glare: f64,
    /// Is `true` if the image has alpha.
    pub alpha: bool,
    /// The planes in addition to color (EXR only).
    pub layers: Vec<Layer>,
    /// Pairs of key and text stored in the file: PNG text chunks, EXR text attributes. Keys are 1 to 79 printable ASCII characters, each
    /// used once; text is any UTF-8 without NUL.
    pub metadata: Vec<(String, String)>,
}

impl FileSettings {
    /// Creates settings for 8-bit color without exposure, tone map, alpha, layers or metadata.
    #[must_use]
    pub fn new(size: [u32; 2]) -> Self {
        Self {
            size,
            window: Window::whole(size),
            exposure: 0.0,
            tonemap: Tonemap::None,
            bits: 8,
            glare: 0.0,
            alpha: false,
            layers: Vec::new(),
            metadata: Vec::new(),
        }
    }

    /// Returns the metadata of the file under a key.
    #[must_use]
    pub fn said(&self, key: &str) -> Option<&str> {
        self.metadata.iter().find_map(|(own, text)| (own == key).then_some(text.as_str()))
    }

    /// Returns the problem of these settings for any format, if there is one.
    fn problem(&self) -> Option<String> {
        let [width, height] = self.size;
        let side = 1..=i32::MAX as u32;
        if !side.contains(&width) || !side.contains(&height) {
            return Some(format!(
                "cannot store an image of {width}x{height} pixels; each side must be from 1 to {} pixels",
                i32::MAX
            ));
        }
        if !self.window.fits(self.size) || self.window.size.contains(&0) {
            return Some(format!("the window {} is not inside the image of {width}x{height} pixels", self.window));
        }
        self.metadata.iter().enumerate().find_map(|(i, (key, text))| {
            let printable = key.bytes().all(|b| (b' '..=b'~').contains(&b));
            if !(1..=79).contains(&key.len()) || !printable || key.trim() != key {
                Some(format!(
                    "the metadata key {key:?} must be 1 to 79 printable ASCII characters, without leading or \
                     trailing spaces"
                ))
            } else if self.metadata[..i].iter().any(|(other, _)| other == key) {
                Some(format!("the metadata key {key:?} is given twice; keep one"))
            } else if text.contains('\0') {
                Some(format!("the metadata text of {key:?} contains a NUL character; remove it"))
            } else {
                None
            }
        })
    }
}

/// A writer of an image, which receives bands from the top down.
///
/// A writer dropped before [`finish`](Self::finish) leaves an existing file unchanged.
pub trait ImageWriter: Send {
    /// Appends a band, which must begin at the row after the last one written.
    ///
    /// # Errors
    ///
    /// Returns [`OutputError::Band`] if the band is not the next one, or lacks a plane of the settings, and an error if it cannot be
    /// encoded or written.
    fn write_band(&mut self, band: &Band) -> Result<(), OutputError>;

    /// Completes the file and moves it to its path.
    ///
    /// # Errors
    ///
    /// Returns [`OutputError::Incomplete`] if rows are missing, and an error if the file cannot be written.
    fn finish(self: Box<Self>) -> Result<(), OutputError>;
}

/// Writes a whole rendering of `scene` to `path`, with its stored layers, as the `render` of a scene file would.
///
/// The extension selects the format, as in [`open`]. The file is written completely or not at all.
///
/// # Errors
///
/// Returns [`OutputError::Format`] for another extension, [`OutputError::Setting`] for layers in a PNG, [`OutputError::Band`] if the
/// rendering is not of the whole image, and an error if the file cannot be created or written.
///
/// # Examples
///
/// ```no_run
/// use bentray::{gpu::Gpu, output::save, render::{Renderer, RenderSettings}, scene::Scene};
///
/// let scene = Scene::load("scenes/black_hole.toml".as_ref(), &[])?;
/// let gpu = Gpu::open(None)?;
/// let picture = Renderer::new(&gpu, &scene, RenderSettings::default())?.render()?;
/// save("picture.exr".as_ref(), &scene, &picture)?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn save(path: &Path, scene: &Scene, rendering: &Rendering) -> Result<(), OutputError> {
    let settings = FileSettings {
        exposure: scene.output.exposure,
        tonemap: scene.output.tonemap,
        bits: scene.output.bits,
        glare: scene.output.glare,
        alpha: scene.is_transparent(),
        layers: rendering.band.layers.iter().map(|(layer, _)| *layer).collect(),
        metadata: origin::scale(scene),
        ..FileSettings::new(scene.image.size)
    };
    let mut writer = open(path, &settings)?;
    writer.write_band(&rendering.band)?;
    writer.finish()
}

/// Returns `true` if a file has this extension, ignoring case.
pub(crate) fn has_extension(path: &Path, name: &str) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case(name))
}

/// The extensions of the formats that store layers.
const WITH_LAYERS: [&str; 4] = ["exr", "npz", "fits", "h5"];

/// Returns `true` if the format of the image at `path` stores layers.
#[must_use]
pub fn stores_layers(path: &Path) -> bool {
    WITH_LAYERS.iter().any(|extension| has_extension(path, extension))
}

/// Returns `true` if `path` has the extension of an image that [`open`] writes.
#[must_use]
pub fn is_picture(path: &Path) -> bool {
    stores_layers(path) || ["png", "npy"].iter().any(|extension| has_extension(path, extension))
}

/// Starts an image at `path` in the format of its extension, and returns its writer: `.png` stores display colors, `.exr`, `.npz`,
/// `.fits` and `.h5` linear colors and layers, and `.npy` linear colors.
///
/// # Errors
///
/// Returns [`OutputError::Setting`] if the settings are invalid for the format, [`OutputError::Format`] for another extension, and an error
/// if the file cannot be created ([`AtomicFile::create`]).
///
/// # Examples
///
/// ```
/// use bentray::output::{FileSettings, open};
/// use bentray::render::Band;
///
/// let folder = tempfile::tempdir()?;
/// let path = folder.path().join("gray.png");
/// let mut writer = open(&path, &FileSettings::new([3, 2]))?;
/// for first_row in 0..2 {
///     let color = [(); 3].map(|()| vec![0.5; 3]);
///     writer.write_band(&Band { first_row, rows: 1, width: 3, color, alpha: None, layers: Vec::new() })?;
/// }
/// assert!(!path.exists());
/// writer.finish()?;
/// assert!(path.exists());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn open(path: &Path, settings: &FileSettings) -> Result<Box<dyn ImageWriter>, OutputError> {
    let extension = path.extension().map(|e| e.to_string_lossy().to_ascii_lowercase());
    let setting = |problem| OutputError::Setting { path: path.to_owned(), problem };
    if let Some(problem) = settings.problem() {
        return Err(setting(problem));
    }
    match extension.as_deref() {
        Some("png") => Ok(Box::new(png::PngWriter::create(path, settings)?)),
        Some("exr") => Ok(Box::new(exr::ExrWriter::create(path, settings)?)),
        Some("npz") => Ok(Box::new(npy::NpzWriter::create(path, settings)?)),
        Some("npy") => Ok(Box::new(npy::NpyWriter::create(path, settings)?)),
        Some("fits") => Ok(Box::new(fits::FitsWriter::create(path, settings)?)),
        Some("h5") => Ok(Box::new(hdf5::Hdf5Writer::create(path, settings)?)),
        _ => Err(OutputError::Format { path: path.to_owned() }),
    }
}
