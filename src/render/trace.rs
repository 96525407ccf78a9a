//! Follows given rays, one by one, through the same passes.

use std::borrow::Cow;

use super::grids::LightGrids;
use super::prepared::Prepared;
use super::ray_tiles::{BATCH, ROW, captured_at, is_swallowed, pixel_tile, ray_tile, read_records};
use super::tile::TileEnd;
use super::{RenderError, RenderSettings, Status, Totals, Traced};
use crate::gpu::{Gpu, GpuError};
use crate::model::Control;
use crate::program::Purpose;
use crate::scene::Scene;

/// The rays to follow.
#[derive(Debug, Clone, Copy)]
pub enum Starts<'s> {
    /// Positions and velocities.
    Given(&'s [[f64; 6]]),
    /// The camera's rays of these pixels, laid out in rows of this length: neighbors in the list run side by side.
    Pixels(&'s [[u32; 2]], u32),
}

impl Starts<'_> {
    /// Returns the purpose of a program that follows these rays.
    #[must_use]
    pub fn purpose(&self) -> Purpose {
        match self {
            Self::Given(_) => Purpose::Trace,
            Self::Pixels(..) => Purpose::Pixels,
        }
    }

    fn len(&self) -> usize {
        match self {
            Self::Given(rays) => rays.len(),
            Self::Pixels(pixels, _) => pixels.len(),
        }
    }
}

/// Follows `rays` (x and v) to their ends.
pub fn trace(
    gpu: &Gpu,
    scene: &Scene,
    settings: &RenderSettings,
    rays: &[[f64; 6]],
) -> Result<(Vec<Traced>, Totals), RenderError> {
    Tracer::new(gpu, scene, settings.clone(), Purpose::Trace)?.follow(Starts::Given(rays))
}

/// Follows the camera's rays of some pixels to their ends.
pub fn trace_pixels(
    gpu: &Gpu,
    scene: &Scene,
    settings: &RenderSettings,
    pixels: &[[u32; 2]],
) -> Result<(Vec<Traced>, Totals), RenderError> {
    Tracer::new(gpu, scene, settings.clone(), Purpose::Pixels)?.follow(Starts::Pixels(pixels, ROW))
}

/// A tracer that follows single rays of a scene and returns their ends.
#[derive(Debug)]
pub struct Tracer<'a> {
    pub(super) prepared: Prepared<'a>,
}

impl<'a> Tracer<'a> {
    /// Creates a tracer for this purpose: `Trace`, `Pixels` or `Bare`.
    pub fn new(
        gpu: &'a Gpu,
        scene: &'a Scene,
        mut settings: RenderSettings,
        purpose: Purpose,
    ) -> Result<Self, RenderError> {
        settings.choice.purpose = purpose;
        settings.choice.layers.clear();
        Ok(Self { prepared: Prepared::new(gpu, Cow::Borrowed(scene), settings, LightGrids::default())? })
    }

    /// Changes the parameters of the step control and the maximum number of segments of a path. The kind of control stays, and no pass is
    /// recompiled.
    pub fn retune(&mut self, control: Control, max_segments: u32) -> Result<(), GpuError> {
        self.prepared.retune(control, max_segments)
    }

    /// Follows rays to their ends; `starts` must match the purpose of the tracer.
    pub fn follow(&mut self, starts: Starts) -> Result<(Vec<Traced>, Totals), RenderError> {
        let prepared = &mut self.prepared;
        let mut totals = Totals::default();
        let mut clock = super::clock::Clock::new(prepared.gpu, true);
        let started = std::time::Instant::now();
        let count = starts.len();
        let mut traced = Vec::with_capacity(count);
        let stage = prepared.gpu.progress.measured("tracing rays", count as f64);
        while traced.len() < count {
            let part = traced.len()..count.min(traced.len() + BATCH);
            let (tile, sample) = match starts {
                Starts::Given(rays) => ray_tile(prepared, &rays[part.clone()])?,
                Starts::Pixels(pixels, row) => pixel_tile(prepared, &pixels[part.clone()], row)?,
            };
            let told = |done: f64| stage.reach(part.start as f64 + done * part.len() as f64);
            prepared.run_sample(&tile, sample, &mut clock, &told)?;
            if prepared.read_tally(&tile, &mut totals, None)? == TileEnd::Done {
                traced.extend(read_records(prepared, &tile, part.len())?);
            }
            if let Starts::Given(rays) = starts {
                let ends = traced[part.start..].iter_mut().zip(&rays[part.start..]);
                let law = prepared.scene.law.facts();
                ends.filter(|(_, ray)| is_swallowed(&law, ray)).for_each(|(end, ray)| *end = captured_at(ray));
            }
        }
        prepared.finish_totals(&mut totals, &clock, started)?;
        // The last row of the state is padded with pixels that have no ray.
        totals.rays = count as u64;
        totals.by_status = count_by_status(&traced);
        Ok((traced, totals))
    }
}

fn count_by_status(traced: &[Traced]) -> Vec<(Status, u64)> {
    let count = |status: Status| traced.iter().filter(|ray| ray.status == status).count() as u64;
    std::iter::once(Status::Alive).chain(Status::ENDS).map(|s| (s, count(s))).filter(|(_, n)| *n > 0).collect()
}
