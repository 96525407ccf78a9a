//! The time of an image's passes.

use crate::render::{RenderError, Renderer};

/// The repeated renders of an image.
pub(super) struct Measured {
    /// The median time of the passes that advance and intersect.
    pub(super) seconds: f64,
    /// The ratio of the longest time to the shortest.
    pub(super) spread: f64,
    /// The colors of the image.
    pub(super) colors: Vec<f32>,
}

/// Renders the image a few times, and returns the time of the advance passes in seconds.
pub(super) fn timed(renderer: &mut Renderer, repeats: usize) -> Result<Measured, RenderError> {
    let mut seconds = Vec::new();
    let mut colors = Vec::new();
    for _ in 0..repeats {
        let picture = renderer.render()?;
        seconds.push(picture.totals.advance().as_secs_f64());
        colors = picture.band.color.concat();
    }
    seconds.sort_by(f64::total_cmp);
    let spread = seconds[repeats - 1] / seconds[0];
    Ok(Measured { seconds: seconds[repeats / 2], spread, colors })
}
