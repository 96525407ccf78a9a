//! Samples an image adaptively.
//!
//! *Theory.* One ray through the corner of every pixel, shared by four pixels, shows where the image changes. A pixel is done if its four
//! corner rays end on the same object with similar colors. Any other pixel takes samples of a low-discrepancy sequence, 16, 32, 64, …,
//! until the standard error of their mean, in display values, is below the scene's tolerance. In chaotic regions the error stays above it
//! (G95 §5): such pixels stop at the scene's number of samples, and are counted.
//!
//! *Practice.* The decision about a pixel depends only on its samples and corners, so that tile borders are invisible; a tile has one extra
//! column and row of corners. Pixels that need more samples are listed on the device; the host reads their number after each doubling. The
//! memory is 36 bytes per pixel, and 8 for the lists. Stars have no error to estimate, and are added to the mean.

use super::clock::Clock;
use super::noise::LUMINANCE;
use super::records::{Records, Row};
use super::sample::{Refines, Sample};
use super::{Adaptive, RenderError, Renderer};
use crate::gpu::{GpuError, Tile};
use crate::program::{Role, constant};

/// The values of `moments` for a pixel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Moments {
    /// The mean red, green, blue and alpha.
    pub color: [f32; 4],
    /// The sums of squared deviations of the samples from their mean: red, green and blue.
    pub squares: [f32; 3],
    /// The number of rays: one through the corner, and one per sample.
    pub rays: u32,
}

impl Renderer<'_> {
    /// Takes all samples of a tile, and adds the samples that its pixels needed to `sums`.
    pub(super) fn sample_adaptively(
        &self,
        tile: &Tile,
        origin: [u32; 2],
        clock: &mut Clock,
        progress: &dyn Fn(f64),
        sums: &mut Adaptive,
    ) -> Result<(), RenderError> {
        let image = &self.prepared.scene.image;
        let first = constant("pass/refine", "FIRST_SAMPLES") as u32;
        let at = |number: u32, refines: Refines| Sample {
            origin,
            image: image.size,
            number,
            is_grid: false,
            ends_only: false,
            refines: Some(refines),
        };
        let pixels = tile.size.map(u64::from).iter().product::<u64>();
        // Progress assumes that all open pixels take the maximum number of samples, because nothing more is known.
        let tell = |taken: u64, open: u64, sample: u32, done: f64| {
            let [taken, open] = [taken, open].map(|rays| rays as f64);
            progress((taken + open * done) / (taken + open * f64::from(image.samples + 1 - sample)));
        };
        if self.prepared.program.features.has_grid {
            self.prepared.run_sample(tile, at(0, Refines::FIRST).grid(), clock, &|_| {})?;
        }
        self.prepared.run_sample(tile, at(0, Refines::FIRST), clock, &|done| tell(0, pixels, 0, done))?;
        sums.samples += pixels;
        let mut taken = pixels;
        let mut open = self.read_refined(tile, sums)?;
        let mut list = Refines::FIRST.list + 1;
        for sample in 1..=image.samples {
            if open == 0 {
                break;
            }
            let refines = Refines { listed: self.prepared.program.features.lists_open(), list };
            self.prepared.run_sample(tile, at(sample, refines), clock, &|done| tell(taken, open, sample, done))?;
            sums.samples += open;
            taken += open;
            if sample >= first && sample.is_power_of_two() {
                open = self.read_refined(tile, sums)?;
                list += 1;
            }
        }
        Ok(())
    }

    /// Returns the number of pixels that need more samples; pixels that reached the cap since the last call are added to `sums`.
    fn read_refined(&self, tile: &Tile, sums: &mut Adaptive) -> Result<u64, GpuError> {
        let records = Records::take(self.prepared.gpu, &self.prepared.program, tile, &Role::Refined)?;
        let Some(refined) = records.rows().next() else { return Ok(0) };
        sums.capped += u64::from(refined.uint("capped"));
        Ok(refined.uint("open").into())
    }
}

impl Moments {
    /// Returns the moments of every pixel of a tile with its margin, row by row; `None` if the tile has none.
    pub(super) fn of(records: &Records) -> Option<Vec<Self>> {
        let [color, alpha, squares, state] = ["color", "alpha", "squares", "state"].map(|name| records.field(name));
        let (color, alpha, squares, state) = (color?, alpha?, squares?, state?);
        let rays = constant("picture/adaptive", "RAYS") as u32;
        let moments = |row: Row| {
            let ([r, g, b], [alpha], [state]) = (row.words(color), row.words(alpha), row.words(state));
            let squares = row.words(squares).map(f32::from_bits);
            Self { color: [r, g, b, alpha].map(f32::from_bits), squares, rays: state & rays }
        };
        Some(records.rows().map(moments).collect())
    }

    /// Returns the standard error of the mean luminance of the samples; an upper bound, which assumes fully correlated channels.
    pub(super) fn error(&self) -> f32 {
        let n = self.rays.saturating_sub(1) as f32;
        if n < 2.0 {
            return f32::INFINITY;
        }
        let of_channel = |(squares, part): (&f32, f32)| part * (squares / (n * (n - 1.0))).sqrt();
        self.squares.iter().zip(LUMINANCE).map(of_channel).sum()
    }
}
