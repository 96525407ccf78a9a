//! Following given rays, one by one, through the same passes.

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

/// Which rays to follow.
#[derive(Debug, Clone, Copy)]
pub enum Starts<'s> {
    /// Places and velocities.
    Given(&'s [[f64; 6]]),
    /// The camera's rays of these pixels, laid out in rows of so many: neighbours in the list run side by side.
    Pixels(&'s [[u32; 2]], u32),
}

impl Starts<'_> {
    /// What a program is for that follows such rays.
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

/// Follows single rays of a scene and tells where they end.
#[derive(Debug)]
pub struct Tracer<'a> {
    pub(super) prepared: Prepared<'a>,
}

impl<'a> Tracer<'a> {
    /// Links, compiles and uploads what follows rays for this purpose: `Trace`, `Pixels` or `Bare`.
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

    /// Changes the numbers of the step control and the segments that a path may have; which control it is stays, and no pass
    /// is compiled again.
    pub fn retune(&mut self, control: Control, max_segments: u32) -> Result<(), GpuError> {
        self.prepared.retune(control, max_segments)
    }

    /// Follows rays to their ends, which start as this was made for.
    pub fn follow(&mut self, starts: Starts) -> Result<(Vec<Traced>, Totals), RenderError> {
        let prepared = &mut self.prepared;
        let mut totals = Totals::default();
        let mut clock = super::clock::Clock::new(prepared.gpu, true);
        let started = std::time::Instant::now();
        let count = starts.len();
        let mut traced = Vec::with_capacity(count);
        let stage = prepared.gpu.progress.measured("following rays", count as f64);
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
        // The last row of the state is filled up with pixels that have no ray.
        totals.rays = count as u64;
        totals.by_status = count_by_status(&traced);
        Ok((traced, totals))
    }
}

fn count_by_status(traced: &[Traced]) -> Vec<(Status, u64)> {
    let count = |status: Status| traced.iter().filter(|ray| ray.status == status).count() as u64;
    std::iter::once(Status::Alive).chain(Status::ENDS).map(|s| (s, count(s))).filter(|(_, n)| *n > 0).collect()
}
