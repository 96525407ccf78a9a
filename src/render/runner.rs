//! The loop that runs a sample's passes: Figure 1 of the 2004 paper.
//!
//! *Theory.* Where surfaces split rays a sample is as many rounds of the same steps as a path's tree may have leaves. A pixel takes
//! part until all of its own have been followed; which pixels those are only the device knows, so that the host records every
//! round there could be.
//!
//! *Practice.* A round that no pixel takes part in is some empty indirect dispatches: a few microseconds each, most of them the
//! host's.

use std::collections::{HashMap, VecDeque};

use wgpu::{
    BindGroup, CommandEncoder, CommandEncoderDescriptor, ComputePass, ComputePassDescriptor, PollType, SubmissionIndex,
};

use super::Renderer;
use super::clock::{Clock, Stage};
use super::plan::Turn;
use super::renderer::{Frame, Refines};
use super::schedule::{Dispatch, Step, refining};
use crate::gpu::{GpuError, OPEN, Slots, TURN_STRIDE, Tile};
use crate::program::Pass;

/// Ray-steps of one submission, about: a few tenths of a second on a slow device, long before any driver's watchdog.
const SUBMISSION: u64 = 1 << 26;
/// Submissions that may be under way at once.
const IN_FLIGHT: usize = 3;

impl Renderer<'_> {
    /// Runs one sample of a tile: all its rounds, in submissions short enough for any driver. `progress` is told the fraction
    /// that is done.
    pub(super) fn run_sample(
        &self,
        tile: &Tile,
        frame: Frame,
        clock: &mut Clock,
        progress: &dyn Fn(f64),
    ) -> Result<(), GpuError> {
        let mut runner = Runner::new(self, tile);
        let rounds = self.settings.choice.rounds(&self.scene);
        let allowed = SUBMISSION / (u64::from(tile.size[0]) * u64::from(tile.size[1]));
        let mut weight = 0;
        for round in 0..rounds {
            // All rounds but the first are told the same.
            if round < 2 {
                runner.submit(clock)?;
                weight = 0;
                self.write_frame(tile, frame, round)?;
            }
            for step in &self.plan().steps {
                weight += step.weight;
                if weight > allowed {
                    runner.submit(clock)?;
                    weight = step.weight;
                    progress(f64::from(round) / f64::from(rounds));
                }
                runner.recorded.push((round, taking_part(*step, round, frame.refines)));
            }
        }
        if let Some(refines) = frame.refines {
            if rounds > 1 {
                runner.submit(clock)?;
                self.write_frame(tile, frame, 0)?;
            }
            runner.recorded.push((0, refining(refines, self.settings.choice.masks)));
        }
        runner.submit(clock)?;
        runner.wait(0)
    }

    /// Runs some steps at once, outside the loop over a whole sample.
    pub(super) fn run_steps(&self, tile: &Tile, frame: Frame, steps: &[Step]) -> Result<(), GpuError> {
        self.write_frame(tile, frame, 0)?;
        let mut runner = Runner::new(self, tile);
        runner.recorded.extend(steps.iter().map(|step| (0, *step)));
        runner.submit(&mut Clock::new(self.gpu, false))?;
        runner.wait(0)
    }
}

/// Later rounds are timed as one: to time a pass may cost more than the pass.
fn stage_of(pass: Pass, round: u32, apart: bool) -> Stage {
    match pass {
        _ if round > 0 => Stage::Advance,
        Pass::Setup => Stage::Setup,
        Pass::Intersect if apart => Stage::Intersect,
        Pass::Scatter if apart => Stage::Scatter,
        Pass::Shade | Pass::Record | Pass::Refine => Stage::Shade,
        _ => Stage::Advance,
    }
}

/// A step of a sample's round: over the pixels that take the sample, if these are listed.
fn taking_part(mut step: Step, round: u32, refines: Option<Refines>) -> Step {
    if let (0, Dispatch::Open, Some(Refines { listed, lists })) = (round, step.dispatch, refines) {
        step.slots.list[0] = lists[0];
        step.dispatch = if listed { Dispatch::Living } else { Dispatch::Grid };
    }
    step
}

/// One sample under way.
struct Runner<'r, 'a> {
    renderer: &'r Renderer<'a>,
    tile: &'r Tile,
    groups: HashMap<(Pass, Slots), BindGroup>,
    /// Steps to be submitted, each with its round.
    recorded: Vec<(u32, Step)>,
    under_way: VecDeque<SubmissionIndex>,
}

impl<'r, 'a> Runner<'r, 'a> {
    fn new(renderer: &'r Renderer<'a>, tile: &'r Tile) -> Self {
        Self { renderer, tile, groups: HashMap::new(), recorded: Vec::new(), under_way: VecDeque::new() }
    }

    /// What is recorded in one submission, the steps of the same stage that follow each other in one pass.
    fn submit(&mut self, clock: &mut Clock) -> Result<(), GpuError> {
        if self.recorded.is_empty() {
            return Ok(());
        }
        let gpu = self.renderer.gpu;
        for i in 0..self.recorded.len() {
            self.prepare(i)?;
        }
        let mut encoder = gpu.device.create_command_encoder(&CommandEncoderDescriptor { label: None });
        let apart = clock.apart;
        if let Some(timestamp_writes) = clock.next(gpu, Stage::Start) {
            let descriptor = ComputePassDescriptor { label: None, timestamp_writes: Some(timestamp_writes) };
            drop(encoder.begin_compute_pass(&descriptor));
        }
        let batch = |round: u32| u64::from(round) / self.renderer.plan().batch.rounds;
        let key = |(round, step): &(u32, Step)| {
            (batch(*round), stage_of(step.pass, *round, apart), step.pass == Pass::Refine)
        };
        for steps in self.recorded.chunk_by(|a, b| key(a) == key(b)) {
            let ((batch, stage, refines), (round, first)) = (key(&steps[0]), steps[0]);
            if let (true, Some(buffer)) = (refines, self.tile.living(first.slots.list[1])) {
                encoder.clear_buffer(buffer, 0, None);
            }
            if first.pass == Pass::Setup && u64::from(round) % self.renderer.plan().batch.rounds == 0 {
                self.clear_lists(&mut encoder, batch);
            }
            let timestamp_writes = clock.next(gpu, stage);
            let mut pass = encoder.begin_compute_pass(&ComputePassDescriptor { label: None, timestamp_writes });
            let mut current = None;
            for (round, step) in steps {
                let slots = step.slots.in_round(*round);
                let (Some(pipeline), Some(group)) =
                    (self.renderer.pipelines.get(step.pass), self.groups.get(&(step.pass, slots)))
                else {
                    continue;
                };
                if current != Some(step.pass) {
                    pass.set_pipeline(&pipeline.pipeline);
                    current = Some(step.pass);
                }
                pass.set_bind_group(0, group, &self.offsets(step, *round));
                self.dispatch(&mut pass, step, *round);
            }
        }
        self.recorded.clear();
        self.under_way.push_back(gpu.queue.submit([encoder.finish()]));
        self.wait(IN_FLIGHT)
    }

    fn prepare(&mut self, i: usize) -> Result<(), GpuError> {
        let (round, step) = self.recorded[i];
        let key = (step.pass, step.slots.in_round(round));
        let renderer = self.renderer;
        if let (false, Some(pipeline)) = (self.groups.contains_key(&key), renderer.pipelines.get(step.pass)) {
            let group = self.tile.bind_group(renderer.gpu, pipeline, &renderer.buffers, key.1)?;
            self.groups.insert(key, group);
        }
        Ok(())
    }

    /// Nothing lives before a round's setup says so, and nothing is open in the next round before its shading says so. What the
    /// batch before has left open stays.
    fn clear_lists(&self, encoder: &mut CommandEncoder, batch: u64) {
        let half = self.renderer.plan().batch.rounds * TURN_STRIDE;
        for list in 0..OPEN + 2 {
            let Some(buffer) = self.tile.living(list) else { continue };
            let (offset, size) = if list < OPEN { (0, None) } else { (batch % 2 * half, Some(half)) };
            encoder.clear_buffer(buffer, offset, size);
        }
    }

    /// Where in the per-pass buffers the step's own parts lie.
    fn offsets(&self, step: &Step, round: u32) -> Vec<u32> {
        let turn = self.renderer.plan().turns.binary_search(&Turn::of(step)).unwrap_or(0) as u64;
        let [read, written] = self.renderer.plan().batch.parts(step, round);
        Tile::offsets(&self.renderer.pipelines, step.pass)
            .into_iter()
            .map(|name| match name {
                "dispatch" => turn,
                "active_in" => read,
                _ => written,
            })
            .map(|part| (part * TURN_STRIDE) as u32)
            .collect()
    }

    fn dispatch(&self, pass: &mut ComputePass, step: &Step, round: u32) {
        let [read, _] = self.renderer.plan().batch.parts(step, round);
        let indirect = match step.dispatch {
            Dispatch::Grid => false,
            Dispatch::Living => true,
            Dispatch::Open => round > 0,
        };
        match self.tile.living(step.slots.in_round(round).list[0]) {
            Some(buffer) if indirect => pass.dispatch_workgroups_indirect(buffer, read * TURN_STRIDE),
            _ => {
                let [across, down] = self.renderer.gpu.group;
                pass.dispatch_workgroups(self.tile.size[0].div_ceil(across), self.tile.size[1].div_ceil(down), 1);
            }
        }
    }

    /// Waits until at most `left` submissions are under way.
    fn wait(&mut self, left: usize) -> Result<(), GpuError> {
        while self.under_way.len() > left {
            let submission_index = self.under_way.pop_front();
            self.renderer
                .gpu
                .device
                .poll(PollType::Wait { submission_index, timeout: None })
                .map_err(|error| GpuError::Lost(error.to_string()))?;
        }
        Ok(())
    }
}
