//! The PNG writer, which stores 8 or 16-bit sRGB for display, row by row.
//!
//! The encoder writes to a channel, from which the bytes are moved to the file after every band. A disk error is therefore always found
//! where it can be reported, also for the encoder's last bytes, which it writes when it is dropped. Host memory: the rows of one band as
//! integers, plus their compressed bytes; with glare, all rows.

use std::{
    collections::BTreeMap,
    io::{self, Write},
    path::Path,
    sync::mpsc::{Receiver, Sender, channel},
};

use ::png::{BitDepth, ColorType, Compression, Encoder, EncodingError, SrgbRenderingIntent, StreamWriter};
use rayon::prelude::*;

use super::color::{SrgbBytes, shown, srgb_from_linear};
use super::glare::spread;
use super::origin::{PART, SHOWN, part_words, shown_words};
use super::{AtomicFile, FileSettings, ImageWriter, OutputError, band::Rows};
use crate::render::{Band, Window};
use crate::scene::Tonemap;

/// The exposure in stops beyond which every `f32` is black or white.
const MAX_STOPS: f64 = 300.0;

/// A writer of a PNG.
pub struct PngWriter {
    rows: Rows,
    shown: Shown,
    encoder: StreamWriter<'static, Outbox>,
    encoded: Receiver<Vec<u8>>,
    file: AtomicFile,
    /// The fraction of light that glare spreads, and the bands so far, because it spreads over the whole image.
    glare: f64,
    held: Option<Band>,
}

/// The conversion of colors to bytes.
struct Shown {
    gain: f64,
    tonemap: Tonemap,
    alpha: bool,
    /// The table for one byte per value; `None` for two.
    bytes: Option<&'static SrgbBytes>,
}

/// The encoder's end of the channel.
struct Outbox(Sender<Vec<u8>>);

impl Write for Outbox {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.send(bytes.to_vec()).map_err(|_| io::ErrorKind::BrokenPipe)?;
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl PngWriter {
    /// Starts a PNG at `path`; returns an error for layers, which the format cannot store.
    ///
    /// # Errors
    ///
    /// Returns [`OutputError::Setting`] for layers, for bits other than 8 or 16, and for an exposure that is out of range; and an error if
    /// the file cannot be created ([`AtomicFile::create`]).
    pub fn create(path: &Path, settings: &FileSettings) -> Result<Self, OutputError> {
        if let Some(problem) = problem(settings) {
            return Err(OutputError::Setting { path: path.to_owned(), problem });
        }
        let file = AtomicFile::create(path)?;
        let (sender, encoded) = channel();
        let encoder = encoder(Outbox(sender), settings).map_err(|e| encode_error(path, e))?;
        Ok(Self {
            rows: Rows::new(path.to_owned(), settings.window.size, settings.alpha, Vec::new()),
            shown: Shown {
                gain: settings.exposure.exp2(),
                tonemap: settings.tonemap,
                alpha: settings.alpha,
                bytes: (settings.bits == 8).then(SrgbBytes::table),
            },
            encoder,
            encoded,
            file,
            glare: settings.glare,
            held: None,
        })
    }

    /// Encodes the rows of a band.
    fn encode(&mut self, band: &Band) -> Result<(), OutputError> {
        for row in self.shown.band_bytes(band) {
            self.encoder.write_all(&row).map_err(|e| encode_error(&self.rows.path, e.into()))?;
        }
        drain(&self.encoded, &mut self.file)
    }
}

impl Shown {
    /// Returns the bytes of one row of a band, from pixel `start` of its planes.
    fn row_bytes(&self, band: &Band, start: usize) -> Vec<u8> {
        // Four channels of two bytes at most.
        let mut out = Vec::with_capacity(8 * band.width as usize);
        for i in start..start + band.width as usize {
            let color = [band.color[0][i], band.color[1][i], band.color[2][i]];
            // PNG colors are not premultiplied.
            let alpha = band.alpha.as_ref().filter(|_| self.alpha).map(|alpha| alpha[i]);
            let color = alpha.map_or(color, |alpha| color.map(|c| if alpha > 0.0 { c / alpha } else { c }));
            let color = shown(color, self.gain, self.tonemap);
            if let Some(bytes) = &self.bytes {
                out.extend(color.map(|value| bytes.of(value)));
                out.extend(alpha.map(|alpha| (f64::from(alpha) * 255.0).round() as u8));
            } else {
                for value in color.map(srgb_from_linear).into_iter().chain(alpha.map(f64::from)) {
                    out.extend(((value * f64::from(u16::MAX)).round() as u16).to_be_bytes());
                }
            }
        }
        out
    }

    /// Returns the bytes of a band's rows, computed on all cores.
    fn band_bytes(&self, band: &Band) -> Vec<Vec<u8>> {
        let width = band.width as usize;
        (0..band.rows as usize).into_par_iter().map(|y| self.row_bytes(band, y * width)).collect()
    }
}

impl ImageWriter for PngWriter {
    fn write_band(&mut self, band: &Band) -> Result<(), OutputError> {
        self.rows.accept(band)?;
        if self.glare > 0.0 {
            match &mut self.held {
                Some(held) => held.append(band.clone()),
                None => self.held = Some(band.clone()),
            }
            return Ok(());
        }
        self.encode(band)
    }

    fn finish(self: Box<Self>) -> Result<(), OutputError> {
        let mut this = *self;
        this.rows.complete()?;
        if let Some(mut whole) = this.held.take() {
            spread(&mut whole, this.glare);
            this.encode(&whole)?;
        }
        this.encoder.finish().map_err(|e| encode_error(&this.rows.path, e))?;
        drain(&this.encoded, &mut this.file)?;
        this.file.finish()
    }
}

/// Moves the encoder's output to the file.
fn drain(encoded: &Receiver<Vec<u8>>, file: &mut AtomicFile) -> Result<(), OutputError> {
    encoded.try_iter().try_for_each(|bytes| file.write_all(&bytes)).map_err(|e| file.failed(e))
}

fn problem(settings: &FileSettings) -> Option<String> {
    if !matches!(settings.bits, 8 | 16) {
        return Some(format!("expected 8 or 16 bits per channel for a PNG, found {}", settings.bits));
    }
    if !(-MAX_STOPS..=MAX_STOPS).contains(&settings.exposure) {
        return Some(format!(
            "expected an exposure from -{MAX_STOPS} to {MAX_STOPS} stops, found {}",
            settings.exposure
        ));
    }
    if settings.glare > 0.0 && settings.window != Window::whole(settings.size) {
        let problem =
            "glare spreads light over the whole image: write an .exr of this part, and merge the parts into a PNG";
        return Some(problem.to_owned());
    }
    (!settings.layers.is_empty()).then(|| "a PNG stores only color; write an .exr for the layers, or omit them".into())
}

fn encoder(outbox: Outbox, settings: &FileSettings) -> Result<StreamWriter<'static, Outbox>, EncodingError> {
    let [width, height] = settings.window.size;
    let mut encoder = Encoder::new(outbox, width, height);
    encoder.set_color(if settings.alpha { ColorType::Rgba } else { ColorType::Rgb });
    encoder.set_depth(if settings.bits == 16 { BitDepth::Sixteen } else { BitDepth::Eight });
    if settings.bits == 8 {
        // Twenty times as fast as the default, for files a fifth larger. The low bytes of 16 bits are noise, which it would expand.
        encoder.set_compression(Compression::Fast);
    }
    encoder.set_source_srgb(SrgbRenderingIntent::Perceptual);
    let own = [(PART, part_words(settings)), (SHOWN, shown_words(settings))];
    let said = settings.metadata.iter().map(|(key, text)| (key.as_str(), text.clone()));
    let said: BTreeMap<&str, String> = said.chain(own).collect();
    for (key, text) in said {
        if text.is_ascii() {
            encoder.add_text_chunk(key.to_owned(), text)?;
        } else {
            encoder.add_itxt_chunk(key.to_owned(), text)?;
        }
    }
    encoder.write_header()?.into_stream_writer()
}

/// Adds the path to an error of the encoder.
pub(super) fn encode_error(path: &Path, error: EncodingError) -> OutputError {
    let path = path.to_owned();
    match error {
        EncodingError::IoError(cause) => OutputError::Write { path, cause },
        other => OutputError::Encode { path, problem: other.to_string() },
    }
}
