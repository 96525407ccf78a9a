//! Runs the passes of a sample: the loop of Figure 1 in W04.
//!
//! *Theory.* If surfaces split rays, a sample has as many rounds of the same steps as the tree of a path may have leaves. A pixel takes
//! part until all its paths have been followed. The host records the steps without knowing which rays remain: passes over an empty list are
//! indirect dispatches that do nothing.
//!
//! *Practice.* An empty dispatch takes a few microseconds, mostly on the host. Each submission therefore returns the number of rays that it
//! left active; the host does not wait for it, and stops recording when the number is 0.

use std::collections::{HashMap, VecDeque};
use std::time::Instant;

use wgpu::{
    BindGroup, CommandEncoder, CommandEncoderDescriptor, ComputePass, ComputePassDescriptor, PollType, SubmissionIndex,
};

use super::clock::{Clock, Stage};
use super::live_rays::{Count, LiveRays};
use super::prepared::Prepared;
use super::sample::Sample;
use super::step::{Dispatch, Step};
use super::submission_size::part;
use crate::gpu::{GpuError, List, PixelListKind, SECTION, SceneBuffers, Selection, Tile};
use crate::program::{Access, Pass, Role};

/// The maximum number of submissions in flight.
const IN_FLIGHT: usize = 3;

impl Prepared<'_> {
    /// Runs one sample of a tile with all its rounds, in submissions short enough for any driver. `progress` receives the completed
    /// fraction of the work whenever a submission ends; the last call receives 1.
    pub(super) fn run_sample(
        &self,
        tile: &Tile,
        sample: Sample,
        clock: &mut Clock,
        progress: &dyn Fn(f64),
    ) -> Result<(), GpuError> {
        let rounds = self.program.features.rounds;
        let all = u64::from(rounds) * self.plan.steps.iter().map(|step| step.weight).sum::<u64>();
        let pixels = u64::from(tile.size[0]) * u64::from(tile.size[1]);
        // The size may change meanwhile, and the fraction must not fall.
        let each = self.submission.get() / pixels;
        let told = |ended: u64| progress(part(ended, all, each));
        let mut runner = Runner::new(self, tile, sample, &told);
        for round in 0..rounds {
            // All rounds after the first use the same values.
            if round < 2 {
                runner.submit(clock)?;
                self.write_sample(tile, sample, round)?;
            }
            let mut last = None;
            for step in &self.plan.steps {
                // The lists are complete at the end of an iteration.
                if last.replace(step.iteration) != Some(step.iteration) {
                    runner.make_room(round, step.weight, clock)?;
                }
                if runner.live.in_round(round) > 0 || step.dispatch != Dispatch::PixelListKind {
                    runner.recorded.push((round, step.in_round(round, sample.refines)));
                }
            }
            if runner.live.is_done() {
                break;
            }
        }
        if let Some(refines) = sample.refines {
            if rounds > 1 {
                runner.submit(clock)?;
                self.write_sample(tile, sample, 0)?;
            }
            runner.recorded.push((0, Step::refining(refines, self.settings.options.masks)));
        }
        runner.submit(clock)?;
        runner.wait(0)?;
        progress(1.0);
        Ok(())
    }

    /// Runs some steps at once, outside the loop over a whole sample.
    pub(super) fn run_steps(&self, tile: &Tile, sample: Sample, steps: &[Step]) -> Result<(), GpuError> {
        self.write_sample(tile, sample, 0)?;
        let mut runner = Runner::new(self, tile, sample, &|_| {});
        runner.recorded.extend(steps.iter().map(|step| (0, *step)));
        runner.submit(&mut Clock::new(self.gpu, false))?;
        runner.wait(0)
    }
}

/// A submission in flight.
struct Submission {
    index: SubmissionIndex,
    /// The weight of its steps.
    weight: u64,
    /// An upper bound of the number of its ray steps.
    work: u64,
    /// The time of the submission.
    begun: Instant,
    /// The number of rays that it leaves.
    count: Option<Count>,
}

/// A sample in progress.
struct Runner<'r, 'a> {
    prepared: &'r Prepared<'a>,
    tile: &'r Tile,
    buffers: &'r SceneBuffers,
    groups: HashMap<(Pass, Selection), BindGroup>,
    /// The steps to submit, each with its round.
    recorded: Vec<(u32, Step)>,
    /// The submissions in flight.
    under_way: VecDeque<Submission>,
    live: LiveRays,
    /// The time at which the last submission ended.
    idle_since: Instant,
    /// The weight of all steps whose submissions have ended, and the function that receives it.
    ended: u64,
    told: &'r dyn Fn(u64),
}

impl<'r, 'a> Runner<'r, 'a> {
    fn new(prepared: &'r Prepared<'a>, tile: &'r Tile, sample: Sample, told: &'r dyn Fn(u64)) -> Self {
        let buffers = prepared.buffers_of(sample.number);
        let (groups, recorded, under_way) = (HashMap::new(), Vec::new(), VecDeque::new());
        let live = LiveRays::all(u64::from(tile.size[0]) * u64::from(tile.size[1]));
        Self { prepared, tile, buffers, groups, recorded, under_way, live, idle_since: Instant::now(), ended: 0, told }
    }

    /// Submits the recorded steps if they and a step of this weight are too much for one submission.
    fn make_room(&mut self, round: u32, weight: u64, clock: &mut Clock) -> Result<(), GpuError> {
        let recorded = self.recorded.iter().map(|(_, step)| step.weight).sum::<u64>();
        let rays = self.live.in_round(round).max(1);
        if (recorded + weight).saturating_mul(rays) > self.prepared.submission.get()
            || self.live.is_full(self.recorded.len())
        {
            self.submit(clock)?;
            self.live.submitted();
        }
        Ok(())
    }

    /// Submits the recorded steps. Consecutive steps of the same stage share a compute pass.
    fn submit(&mut self, clock: &mut Clock) -> Result<(), GpuError> {
        if self.recorded.is_empty() {
            return Ok(());
        }
        let gpu = self.prepared.gpu;
        for i in 0..self.recorded.len() {
            self.bind(i)?;
        }
        let mut encoder = gpu.device.create_command_encoder(&CommandEncoderDescriptor { label: None });
        let apart = clock.apart;
        if let Some(timestamp_writes) = clock.next(gpu, Stage::Start) {
            let descriptor = ComputePassDescriptor { label: None, timestamp_writes: Some(timestamp_writes) };
            drop(encoder.begin_compute_pass(&descriptor));
            clock.settle(&mut encoder);
        }
        let lists = self.prepared.plan.batch;
        let batch = |round: u32| u64::from(round) / lists.rounds;
        let key = |(round, step): &(u32, Step)| {
            (batch(*round), Stage::of(step.pass, *round, apart), step.pass == Pass::Refine)
        };
        for steps in self.recorded.chunk_by(|a, b| key(a) == key(b)) {
            let ((batch, stage, refines), (round, first)) = (key(&steps[0]), steps[0]);
            if let (true, Some(buffer)) = (refines, self.tile.arguments(lists.place(first.written, round).list)) {
                encoder.clear_buffer(buffer, 0, None);
            }
            if first.pass == Pass::Setup && u64::from(round) % lists.rounds == 0 {
                self.clear_lists(&mut encoder, batch);
            }
            let timestamp_writes = clock.next(gpu, stage);
            let mut pass = encoder.begin_compute_pass(&ComputePassDescriptor { label: None, timestamp_writes });
            let mut current = None;
            for (round, step) in steps {
                let key = (step.pass, lists.selection(step, *round));
                let (Some(pipeline), Some(group)) = (self.prepared.pipelines.get(step.pass), self.groups.get(&key))
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
            drop(pass);
            clock.settle(&mut encoder);
        }
        let mut count = self.recorded.last().and_then(|(round, step)| self.count(*round, step, &mut encoder));
        let index = gpu.queue.submit([encoder.finish()]);
        count.iter_mut().for_each(Count::request);
        let work = self.recorded.iter().map(|(round, step)| step.weight.saturating_mul(self.live.in_round(*round)));
        let work = work.fold(0, u64::saturating_add);
        let weight = self.recorded.drain(..).map(|(_, step)| step.weight).sum();
        self.under_way.push_back(Submission { index, weight, work, begun: Instant::now(), count });
        self.wait(IN_FLIGHT)
    }

    /// Records the copy of the number of rays that a step leaves.
    fn count(&self, round: u32, step: &Step, encoder: &mut CommandEncoder) -> Option<Count> {
        let prepared = self.prepared;
        let layout = prepared.program.layout(&Role::Arguments(Access::Write))?;
        let offset = u64::from(layout.field("x")?.offset);
        let section = prepared.plan.batch.place(step.written, round);
        Count::record(prepared.gpu, self.tile, (step.written, round), (section, offset), encoder)
    }

    fn bind(&mut self, i: usize) -> Result<(), GpuError> {
        let (round, step) = self.recorded[i];
        let prepared = self.prepared;
        let key = (step.pass, prepared.plan.batch.selection(&step, round));
        if let (false, Some(pipeline)) = (self.groups.contains_key(&key), prepared.pipelines.get(step.pass)) {
            let group = self.tile.bind_group(prepared.gpu, pipeline, self.buffers, key.1)?;
            self.groups.insert(key, group);
        }
        Ok(())
    }

    /// Clears the lists of a batch: no ray is active before a round's setup lists it, and no pixel is open in the next round before the
    /// shading lists it. Pixels that the previous batch left open are kept.
    fn clear_lists(&self, encoder: &mut CommandEncoder, batch: u64) {
        let half = self.prepared.plan.batch.rounds * SECTION;
        for (of, offset, size) in
            [(PixelListKind::Active, 0, None), (PixelListKind::Open, batch % 2 * half, Some(half))]
        {
            for list in List::both(of) {
                if let Some(buffer) = self.tile.arguments(list) {
                    encoder.clear_buffer(buffer, offset, size);
                }
            }
        }
    }

    /// Returns the offsets of the step's sections in the divided buffers, in the order of the bindings.
    fn offsets(&self, step: &Step, round: u32) -> Vec<u32> {
        let plan = &self.prepared.plan;
        let bindings = self.prepared.pipelines.get(step.pass).map_or(&[][..], |pipeline| &pipeline.bindings);
        let offset = |role: &Role| match role {
            Role::Parameters => Some(plan.parameters_of(step) * SECTION),
            Role::Arguments(Access::Read) => Some(plan.batch.place(step.read, round).offset()),
            Role::Arguments(Access::Write) => Some(plan.batch.place(step.written, round).offset()),
            _ => None,
        };
        bindings.iter().filter_map(|binding| offset(&binding.role)).map(|offset| offset as u32).collect()
    }

    fn dispatch(&self, pass: &mut ComputePass, step: &Step, round: u32) {
        let indirect = match step.dispatch {
            Dispatch::Grid => false,
            Dispatch::PixelListKind => true,
            Dispatch::ListedLater => round > 0,
        };
        let read = self.prepared.plan.batch.place(step.read, round);
        match self.tile.arguments(read.list) {
            Some(buffer) if indirect => pass.dispatch_workgroups_indirect(buffer, read.offset()),
            _ => {
                let [across, down] = self.prepared.pipelines.group;
                let rows = down * if step.pass == Pass::Whole { self.prepared.gpu.profile.lane_pixels } else { 1 };
                pass.dispatch_workgroups(self.tile.size[0].div_ceil(across), self.tile.size[1].div_ceil(rows), 1);
            }
        }
    }

    /// Waits until at most `left` submissions are in flight.
    fn wait(&mut self, left: usize) -> Result<(), GpuError> {
        while self.under_way.len() > left {
            let Some(Submission { index, weight, work, begun, count }) = self.under_way.pop_front() else { break };
            self.prepared
                .gpu
                .device
                .poll(PollType::Wait { submission_index: Some(index), timeout: None })
                .map_err(|error| GpuError::Lost(error.to_string()))?;
            // The device begins a submission when the previous one has ended.
            let now = Instant::now();
            self.prepared.submission.learn(work, now - begun.max(self.idle_since));
            self.idle_since = now;
            if let Some(count) = count
                && let Some(rays) = count.take()
            {
                self.live.know(count.list, count.round, rays);
            }
            self.ended += weight;
            (self.told)(self.ended);
        }
        Ok(())
    }
}
