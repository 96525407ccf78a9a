//! Runs the passes of samples: the loop of Figure 1 in W04.
//!
//! *Theory.* If surfaces split rays, a sample has as many rounds of the same steps as the tree of a path may have leaves. A pixel takes
//! part until all its paths have been followed. The host records the steps without knowing which rays remain: passes over an empty list are
//! indirect dispatches that do nothing.
//!
//! *Practice.* An empty dispatch takes a few microseconds, mostly on the host. Each submission therefore returns the number of rays that it
//! left active; the host does not wait for it, and stops recording when the number is 0. Samples follow each other without a wait, because
//! each has its own frame in the device's memory.

use std::collections::{HashMap, VecDeque};
use std::time::Instant;

use wgpu::{BindGroup, CommandEncoder, CommandEncoderDescriptor, ComputePass, ComputePassDescriptor, SubmissionIndex};

use super::clock::{Clock, Stage};
use super::live_rays::{Count, LiveRays};
use super::prepared::Prepared;
use super::sample::Sample;
use super::step::{Dispatch, Step};
use crate::gpu::{Division, FRAMES, GpuError, List, PixelListKind, SECTION, Selection, Tile, WORK_HEAD};
use crate::program::{Access, Pass, Role};

/// The maximum number of submissions in flight.
const IN_FLIGHT: usize = 3;

/// A position in the work on a tile: the number of completed samples, and the weight of the completed steps of the next one.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Reached {
    pub sample: usize,
    pub weight: u64,
}

/// A step to submit.
#[derive(Debug, Clone, Copy)]
struct Recorded {
    round: u32,
    step: Step,
    /// The section with its frame.
    frame: u64,
    /// The number of the sample in the image, which selects the moment that it shows.
    number: u32,
}

/// A submission in flight.
struct Submission {
    index: SubmissionIndex,
    /// The position at its end.
    reached: Reached,
    /// An upper bound of the number of its ray steps.
    work: u64,
    /// The time of the submission.
    begun: Instant,
    /// The number of rays that it leaves.
    count: Option<Count>,
}

/// Samples in progress.
pub(super) struct Runner<'r, 'a> {
    prepared: &'r Prepared<'a>,
    tile: &'r Tile,
    groups: HashMap<(Pass, Selection, usize), BindGroup>,
    /// The steps to submit, and the number of their ray steps.
    recorded: Vec<Recorded>,
    work: u64,
    /// The section with the current frame, and the number of its sample.
    frame: (u64, u32),
    /// The position after the recorded steps.
    reached: Reached,
    /// The submissions in flight.
    under_way: VecDeque<Submission>,
    live: LiveRays,
    /// The time at which the last submission ended.
    idle_since: Instant,
    /// The function that receives the position at the end of each submission.
    told: &'r dyn Fn(Reached),
}

impl<'r, 'a> Runner<'r, 'a> {
    pub(super) fn new(prepared: &'r Prepared<'a>, tile: &'r Tile, told: &'r dyn Fn(Reached)) -> Self {
        Self {
            prepared,
            tile,
            groups: HashMap::new(),
            recorded: Vec::new(),
            work: 0,
            frame: (FRAMES - 1, 0),
            reached: Reached::default(),
            under_way: VecDeque::new(),
            live: LiveRays::all(tile.pixels()),
            idle_since: Instant::now(),
            told,
        }
    }

    /// Records the k-th sample, and submits its steps when they are enough.
    pub(super) fn record(&mut self, k: usize, sample: Sample, clock: &mut Clock) -> Result<(), GpuError> {
        let prepared = self.prepared;
        self.reached = Reached { sample: k, weight: 0 };
        self.live = LiveRays::all(self.tile.pixels());
        for round in 0..prepared.program.features.rounds {
            // All rounds after the first use the same frame.
            if round < 2 {
                self.begin_round(sample, round, clock)?;
            }
            self.record_round(sample, round, clock)?;
            if sample.is_grid_of(&prepared.program.features) {
                for pass in prepared.program.features.grid_passes() {
                    self.push(round, Step::of_grid(pass));
                }
            }
            if self.live.is_done() {
                break;
            }
        }
        if let Some(refines) = sample.refines.filter(|_| !sample.is_grid) {
            self.begin_round(sample, 0, clock)?;
            self.push(0, Step::refining(refines, prepared.settings.options.masks));
        }
        Ok(())
    }

    /// Records the steps of a round, and submits them when they are enough.
    pub(super) fn record_round(&mut self, sample: Sample, round: u32, clock: &mut Clock) -> Result<(), GpuError> {
        let prepared = self.prepared;
        let mut last = None;
        for step in &prepared.plan.steps {
            // The lists are complete at the end of an iteration.
            if last.replace(step.iteration) != Some(step.iteration) {
                self.make_room(round, step.weight, clock)?;
            }
            if self.live.in_round(round) > 0 || step.dispatch != Dispatch::PixelListKind {
                self.push(round, step.in_round(round, sample.refines));
            }
        }
        Ok(())
    }

    /// Writes the frame of a round for the steps that follow.
    pub(super) fn begin_round(&mut self, sample: Sample, round: u32, clock: &mut Clock) -> Result<(), GpuError> {
        let next = (self.frame.0 + 1) % FRAMES;
        if next == 0 {
            // Recorded steps may use the frames that are overwritten.
            self.submit(clock)?;
        }
        self.frame = (next, sample.number);
        self.prepared.write_sample(self.tile, sample, round, next)
    }

    pub(super) fn push(&mut self, round: u32, step: Step) {
        let (frame, number) = self.frame;
        self.recorded.push(Recorded { round, step, frame, number });
        self.work = self.work.saturating_add(step.weight.saturating_mul(self.live.in_round(round)));
        self.reached.weight += step.weight;
    }

    /// Submits the recorded steps if they and a step of this weight are too much for one submission.
    fn make_room(&mut self, round: u32, weight: u64, clock: &mut Clock) -> Result<(), GpuError> {
        let more = weight.saturating_mul(self.live.in_round(round).max(1));
        let is_full = self.work.saturating_add(more) > self.prepared.submission.get();
        if !self.recorded.is_empty() && (is_full || self.live.is_full(self.recorded.len())) {
            self.submit(clock)?;
            self.live.submitted();
        }
        Ok(())
    }

    /// Submits the recorded steps. Consecutive steps of the same stage share a compute pass.
    pub(super) fn submit(&mut self, clock: &mut Clock) -> Result<(), GpuError> {
        if self.recorded.is_empty() {
            return Ok(());
        }
        let gpu = self.prepared.gpu;
        for i in 0..self.recorded.len() {
            self.bind(self.recorded[i])?;
        }
        let mut encoder = gpu.device.create_command_encoder(&CommandEncoderDescriptor { label: None });
        let apart = clock.apart;
        if let Some(timestamp_writes) = clock.next(gpu, Stage::Start) {
            let descriptor = ComputePassDescriptor { label: None, timestamp_writes: Some(timestamp_writes) };
            drop(encoder.begin_compute_pass(&descriptor));
            clock.settle(&mut encoder);
        }
        let rounds = self.prepared.plan.batch.rounds;
        let key = |Recorded { round, step, .. }: &Recorded| {
            let clears = matches!(step.pass, Pass::Refine | Pass::FindStars) || self.clears_grid(step.pass);
            (u64::from(*round) / rounds, Stage::of(step.pass, *round, apart), clears.then_some(step.pass))
        };
        for steps in self.recorded.chunk_by(|a, b| key(a) == key(b)) {
            let (_, stage, _) = key(&steps[0]);
            self.clear_before(&steps[0], &mut encoder);
            let timestamp_writes = clock.next(gpu, stage);
            let mut pass = encoder.begin_compute_pass(&ComputePassDescriptor { label: None, timestamp_writes });
            let mut current = None;
            for recorded in steps {
                let step = &recorded.step;
                let (Some(pipeline), Some(group)) =
                    (self.prepared.pipelines.get(step.pass), self.groups.get(&self.key(recorded)))
                else {
                    continue;
                };
                if current != Some(step.pass) {
                    pass.set_pipeline(&pipeline.pipeline);
                    current = Some(step.pass);
                }
                pass.set_bind_group(0, group, &self.offsets(recorded));
                self.dispatch(&mut pass, step, recorded.round);
            }
            drop(pass);
            clock.settle(&mut encoder);
        }
        let mut count = self.recorded.last().and_then(|last| self.count(last.round, &last.step, &mut encoder));
        let index = gpu.submit(encoder);
        count.iter_mut().for_each(Count::request);
        self.recorded.clear();
        let work = std::mem::take(&mut self.work);
        self.under_way.push_back(Submission { index, reached: self.reached, work, begun: Instant::now(), count });
        // The first one shows how large the others may be.
        self.wait(if self.prepared.submission.is_known() { IN_FLIGHT } else { 0 })
    }

    /// Clears the buffers to which the passes from this step on add.
    fn clear_before(&self, Recorded { round, step, .. }: &Recorded, encoder: &mut CommandEncoder) {
        let lists = self.prepared.plan.batch;
        if let (true, Some(rays)) = (self.clears_grid(step.pass), self.tile.buffer(&Role::GridRays)) {
            encoder.clear_buffer(rays, 0, None);
        }
        let (buffer, size) = match step.pass {
            Pass::Setup if u64::from(*round) % lists.rounds == 0 => {
                return self.clear_lists(encoder, u64::from(*round) / lists.rounds);
            }
            Pass::Refine => (self.tile.arguments(lists.place(step.written, *round).list), None),
            Pass::FindStars => (self.tile.buffer(&Role::StarWork(Access::Read)), Some(WORK_HEAD)),
            _ => return,
        };
        if let Some(buffer) = buffer {
            encoder.clear_buffer(buffer, 0, size);
        }
    }

    /// Returns `true` if a pass begins a round of a grid with several: a pixel without a path in this round has no ray on its grid.
    fn clears_grid(&self, pass: Pass) -> bool {
        let features = &self.prepared.program.features;
        pass == Pass::Setup && features.has_grid && features.rounds > 1
    }

    /// Records the copy of the number of rays that a step leaves.
    fn count(&self, round: u32, step: &Step, encoder: &mut CommandEncoder) -> Option<Count> {
        let prepared = self.prepared;
        let layout = prepared.program.layout(&Role::Arguments(Access::Write))?;
        let offset = u64::from(layout.field("x")?.offset);
        let section = prepared.plan.batch.place(step.written, round);
        Count::record(prepared.gpu, self.tile, (step.written, round), (section, offset), encoder)
    }

    /// Returns the key of a step's bind group.
    fn key(&self, Recorded { round, step, number, .. }: &Recorded) -> (Pass, Selection, usize) {
        (step.pass, self.prepared.plan.batch.selection(step, *round), self.prepared.moment_of(*number))
    }

    fn bind(&mut self, recorded: Recorded) -> Result<(), GpuError> {
        let prepared = self.prepared;
        let key = self.key(&recorded);
        if let (false, Some(pipeline)) = (self.groups.contains_key(&key), prepared.pipelines.get(key.0)) {
            let buffers = prepared.buffers_of(recorded.number);
            let group = self.tile.bind_group(prepared.gpu, pipeline, buffers, key.1)?;
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
    fn offsets(&self, Recorded { round, step, frame, .. }: &Recorded) -> Vec<u32> {
        let plan = &self.prepared.plan;
        let bindings = self.prepared.pipelines.get(step.pass).map_or(&[][..], |pipeline| &pipeline.bindings);
        let offset = |role: &Role| match role {
            Role::Frame => Some(frame * SECTION),
            Role::Parameters => Some(plan.parameters_of(step) * SECTION),
            Role::Arguments(Access::Read) => Some(plan.batch.place(step.read, *round).offset()),
            Role::Arguments(Access::Write) => Some(plan.batch.place(step.written, *round).offset()),
            _ => None,
        };
        bindings.iter().filter_map(|binding| offset(&binding.role)).map(|offset| offset as u32).collect()
    }

    fn dispatch(&self, pass: &mut ComputePass, step: &Step, round: u32) {
        let indirect = match step.dispatch {
            Dispatch::Grid => false,
            Dispatch::Stars => {
                if let Some(work) = self.tile.buffer(&Role::StarWork(Access::Read)) {
                    pass.dispatch_workgroups_indirect(work, 0);
                }
                return;
            }
            Dispatch::PixelListKind => true,
            Dispatch::ListedLater => round > 0,
        };
        let read = self.prepared.plan.batch.place(step.read, round);
        match self.tile.arguments(read.list) {
            Some(buffer) if indirect => pass.dispatch_workgroups_indirect(buffer, read.offset()),
            _ => {
                let Division { group: [across, down], lane_pixels } = self.prepared.pipelines.division;
                let rows = down * if step.pass == Pass::Whole { lane_pixels } else { 1 };
                pass.dispatch_workgroups(self.tile.size[0].div_ceil(across), self.tile.size[1].div_ceil(rows), 1);
            }
        }
    }

    /// Waits until at most `left` submissions are in flight.
    pub(super) fn wait(&mut self, left: usize) -> Result<(), GpuError> {
        while self.under_way.len() > left {
            let Some(Submission { index, reached, work, begun, count }) = self.under_way.pop_front() else { break };
            self.prepared.gpu.wait(index)?;
            // The device begins a submission when the previous one has ended.
            let now = Instant::now();
            self.prepared.submission.learn(work, now - begun.max(self.idle_since));
            self.idle_since = now;
            if let Some(count) = count.filter(|_| reached.sample == self.reached.sample)
                && let Some(rays) = count.take()
            {
                self.live.know(count.list, count.round, rays);
            }
            (self.told)(reached);
        }
        Ok(())
    }
}
