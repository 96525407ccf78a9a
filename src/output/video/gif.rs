//! The GIF format with 256 colors per frame, for small animations on any page.
//!
//! The GIF clock has ticks of a hundredth of a second. Each frame is shown from the tick nearest to its time until the next one's, so that
//! the total duration is correct.

use ::image::codecs::gif::{GifEncoder, Repeat};
use ::image::{Delay, Frame, ImageError};

use super::{Frames, before_black};
use crate::output::{AtomicFile, OutputError};

/// The treatment of partially transparent pixels, which the format does not support.
pub(super) const ALPHA: Option<&str> = Some("partly transparent pixels are blended with black");
/// The number of ticks per second.
const TICKS: f64 = 100.0;
/// The sampling of pixels for the 256 colors, from 1 (all) to 30.
const SPEED: i32 = 10;

pub(super) fn write(file: &mut AtomicFile, frames: &mut Frames, _: &'static str) -> Result<(), OutputError> {
    let (path, rate) = (file.path().to_owned(), frames.rate);
    let failed = |error: ImageError| match error {
        ImageError::IoError(cause) => OutputError::Write { path: path.clone(), cause },
        other => OutputError::Encode { path: path.clone(), problem: other.to_string() },
    };
    let mut encoder = GifEncoder::new_with_speed(file, SPEED);
    encoder.set_repeat(Repeat::Infinite).map_err(failed)?;
    let mut shown = 0;
    for number in 1.. {
        let Some(mut picture) = frames.next()? else { break };
        for pixel in picture.pixels_mut() {
            let [r, g, b] = before_black(*pixel);
            pixel.0 = [r, g, b, if pixel[3] == 0 { 0 } else { u8::MAX }];
        }
        let until = (f64::from(number) * TICKS / rate).round() as u32;
        let delay = Delay::from_numer_denom_ms(10 * (until - shown), 1);
        shown = until;
        encoder.encode_frame(Frame::from_parts(picture, 0, 0, delay)).map_err(failed)?;
    }
    Ok(())
}
