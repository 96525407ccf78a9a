//! The animated PNG format, which is lossless and produces large files.

use png::{BitDepth, ColorType, Compression, Encoder, SrgbRenderingIntent};

use super::Frames;
use crate::output::png::encode_error;
use crate::output::{AtomicFile, OutputError};

/// The parts of a second that count a frame's duration if the rate is not an integer.
const PARTS: f64 = 1000.0;

pub(super) fn write(file: &mut AtomicFile, frames: &mut Frames, _: &'static str) -> Result<(), OutputError> {
    let path = file.path().to_owned();
    let failed = |error| encode_error(&path, error);
    let mut encoder = Encoder::new(file, frames.size[0], frames.size[1]);
    encoder.set_color(ColorType::Rgba);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_compression(Compression::Fast);
    encoder.set_source_srgb(SrgbRenderingIntent::Perceptual);
    encoder.set_animated(frames.count() as u32, 0).map_err(failed)?;
    let (part, whole) = delay(frames.rate);
    encoder.set_frame_delay(part, whole).map_err(failed)?;
    let mut writer = encoder.write_header().map_err(failed)?;
    while let Some(picture) = frames.next()? {
        writer.write_image_data(picture.as_raw()).map_err(failed)?;
    }
    writer.finish().map_err(failed)
}

/// Returns the duration of a frame in seconds, as a fraction.
fn delay(rate: f64) -> (u16, u16) {
    if rate.fract() == 0.0 && rate <= f64::from(u16::MAX) {
        return (1, rate as u16);
    }
    ((PARTS / rate).round().clamp(1.0, f64::from(u16::MAX)) as u16, PARTS as u16)
}
