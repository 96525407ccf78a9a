//! A scene made ready for a device, and the loop that runs its passes: Figure 1 of the 2004 paper.

use std::collections::{HashMap, VecDeque};
use std::time::Instant;

use wgpu::{
    BindGroup, BufferUsages, CommandEncoderDescriptor, ComputePassDescriptor, ErrorFilter, PollType, SubmissionIndex,
};

use super::clock::{Clock, Stage};
use super::readback::read_buffer;
use super::schedule::{Dispatch, Step, steps};
use super::{RenderError, Totals};
use crate::gpu::Value::{self, Uint, Uint2};
use crate::gpu::{
    Geometry, Gpu, GpuError, Memory, Pipelines, SceneBuffers, Slots, TURN_STRIDE, Tile, control_values, copy_of,
    memory, pack, schedule_values,
};
use crate::program::{BindingKind, Choice, Pass, Program, Purpose};
use crate::scene::{Control, Scene};

/// How to render.
#[derive(Debug, Clone)]
pub struct Settings {
    /// Schedule, masks, purpose and layers.
    pub choice: Choice,
    /// K: segments of one fused pass, at most.
    pub segments: u32,
    /// The largest tile, in pixels; the device's limits apply besides.
    pub tile_pixels: u64,
    /// Is scattering timed apart from advancing, where it has a pass? That takes a pass of the encoder for each round, which costs
    /// more than the round where nothing lives.
    pub scatter_apart: bool,
}

impl Default for Settings {
    fn default() -> Self {
        // A quarter of a gigabyte of state and more at 100 bytes a pixel: enough to fill any device.
        Self { choice: Choice::default(), segments: 16, tile_pixels: 1 << 22, scatter_apart: false }
    }
}

/// A scene's program, pipelines and data on a device.
#[derive(Debug)]
pub struct Renderer<'a> {
    pub(super) gpu: &'a Gpu,
    pub(super) scene: &'a Scene,
    pub(super) settings: Settings,
    /// The linked program.
    pub program: Program,
    pipelines: Pipelines,
    buffers: SceneBuffers,
    max_segments: u32,
    steps: Vec<Step>,
    /// What differs between steps: (start slot, end slot, again).
    turns: Vec<(usize, usize, bool)>,
}

/// Ray-steps of one submission, about: a few tenths of a second on a slow device, long before any driver's watchdog.
const SUBMISSION: u64 = 1 << 26;
/// Submissions that may be under way at once.
const IN_FLIGHT: usize = 3;

/// A part of the picture and a sample of it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frame {
    pub origin: [u32; 2],
    pub image: [u32; 2],
    pub sample: u32,
    /// The round of branches.
    pub branch: u32,
}

fn turn_of(step: &Step) -> (usize, usize, bool) {
    (step.slots.start, step.slots.end, step.again)
}

impl<'a> Renderer<'a> {
    /// Links, compiles and uploads.
    pub fn new(gpu: &'a Gpu, scene: &'a Scene, settings: Settings) -> Result<Self, RenderError> {
        if settings.choice.purpose != Purpose::Trace && scene.camera.is_none() {
            return Err(RenderError::NoCamera);
        }
        let geometry = Geometry::new(scene);
        let program = Program::new(scene, &settings.choice, geometry.nodes.len(), geometry.triangles.len())?;
        let pipelines = Pipelines::new(gpu, &program)?;
        let buffers = SceneBuffers::new(gpu, scene, &geometry, &program, settings.segments)?;
        let max_segments = scene.rays.max_segments;
        let (steps, turns) = (Vec::new(), Vec::new());
        let mut made = Self { gpu, scene, settings, program, pipelines, buffers, max_segments, steps, turns };
        made.plan_steps();
        Ok(made)
    }

    /// Changes the numbers of the step control and the segments that a path may have; which control it is stays, and no pass
    /// is compiled again.
    pub fn retune(&mut self, control: Control, max_segments: u32) -> Result<(), GpuError> {
        self.rewrite("control", &control_values(control))?;
        self.max_segments = max_segments;
        self.rewrite("schedule", &schedule_values(max_segments, self.settings.segments, &self.program.work))?;
        self.plan_steps();
        Ok(())
    }

    fn rewrite(&self, name: &str, values: &[(&'static str, Value)]) -> Result<(), GpuError> {
        for binding in self.program.passes.iter().flat_map(|(_, _, reflection)| &reflection.bindings) {
            let BindingKind::Block { members, .. } = &binding.kind else { continue };
            let Some(buffer) = self.buffers.buffers.get(&binding.name) else { continue };
            for member in members.iter().filter(|member| copy_of(&member.name).0 == name) {
                let bytes = pack(name, &member.layout, [values])?;
                self.gpu.queue.write_buffer(buffer, u64::from(member.offset), &bytes);
            }
        }
        Ok(())
    }

    fn plan_steps(&mut self) {
        let Self { scene, settings, program, max_segments, .. } = self;
        self.steps = steps(scene, &settings.choice, &program.work, *max_segments, settings.segments);
        self.turns = self.steps.iter().map(turn_of).collect();
        self.turns.sort_unstable();
        self.turns.dedup();
    }

    /// What each pixel costs on the device.
    #[must_use]
    pub fn memory(&self) -> Memory {
        memory(&self.program, self.settings.choice.slots(self.scene))
    }

    pub(super) fn steps(&self) -> &[Step] {
        &self.steps
    }

    /// A tile of this program's state.
    pub(super) fn tile(&self, size: [u32; 2]) -> Result<Tile, GpuError> {
        let scope = self.gpu.device.push_error_scope(ErrorFilter::OutOfMemory);
        let rounds = 1 + self.steps.iter().map(|step| step.round).max().unwrap_or(0);
        let parts = rounds.max(self.turns.len() as u64);
        let slots = self.settings.choice.slots(self.scene);
        let tile = Tile::new(self.gpu, &self.program, size, slots, parts)?;
        if let Some(error) = pollster::block_on(scope.pop()) {
            return Err(GpuError::Lost(error.to_string()));
        }
        if let Some(turn) = self.binding_layout("turn") {
            for (i, &(start, end, again)) in self.turns.iter().enumerate() {
                let row = [("start", Uint(start as u32)), ("end", Uint(end as u32)), ("again", Uint(again.into()))];
                self.write(&tile, "turn", i as u64 * TURN_STRIDE, &pack("turn", turn, [row])?);
            }
        }
        Ok(tile)
    }

    pub(super) fn binding_layout(&self, name: &str) -> Option<&crate::program::Layout> {
        let bindings = self.program.passes.iter().flat_map(|(_, _, reflection)| &reflection.bindings);
        bindings.filter(|binding| binding.name == name).find_map(|binding| match &binding.kind {
            BindingKind::Uniform(layout) | BindingKind::Storage { layout, .. } => Some(layout),
            _ => None,
        })
    }

    fn write(&self, tile: &Tile, name: &str, offset: u64, bytes: &[u8]) {
        if let Some(buffer) = tile.buffer(name) {
            self.gpu.queue.write_buffer(buffer, offset, bytes);
        }
    }

    fn write_frame(&self, tile: &Tile, frame: Frame) -> Result<(), GpuError> {
        let Some(layout) = self.binding_layout("frame") else { return Ok(()) };
        let row = [
            ("origin", Uint2(frame.origin)),
            ("size", Uint2(tile.size)),
            ("image", Uint2(frame.image)),
            ("sample", Uint(frame.sample)),
            ("branch", Uint(frame.branch)),
            ("zero", Uint(0)),
        ];
        self.write(tile, "frame", 0, &pack("frame", layout, [row])?);
        Ok(())
    }

    /// Runs one sample of a tile: all its steps, in submissions short enough for any driver. `progress` is told the
    /// fraction that is done.
    pub(super) fn run_sample(
        &self,
        tile: &Tile,
        frame: Frame,
        clock: &mut Clock,
        progress: &dyn Fn(f64),
    ) -> Result<(), GpuError> {
        self.write_frame(tile, frame)?;
        let mut runner = Runner { renderer: self, tile, groups: HashMap::new(), under_way: VecDeque::new() };
        runner.clear_living();
        let pixels = u64::from(tile.size[0]) * u64::from(tile.size[1]);
        let weights: u64 = self.steps.iter().map(|step| step.weight).sum();
        let mut done = 0;
        let mut rest = self.steps.as_slice();
        while !rest.is_empty() {
            let mut weight = 0;
            let fits = |step: &&Step| {
                weight += step.weight;
                weight == step.weight || weight * pixels <= SUBMISSION
            };
            let count = rest.iter().take_while(fits).count();
            let (now, later) = rest.split_at(count.max(1));
            runner.submit(now, clock)?;
            done += now.iter().map(|step| step.weight).sum::<u64>();
            progress(done as f64 / weights as f64);
            rest = later;
        }
        runner.wait(0)
    }

    /// Adds the tile's tally to `totals`, and clears it.
    pub(super) fn read_tally(&self, tile: &Tile, totals: &mut Totals) -> Result<(), GpuError> {
        let Some(buffer) = tile.buffer("tally") else { return Ok(()) };
        let bytes = read_buffer(self.gpu, buffer, |_| {})?;
        totals.add_tally(&bytemuck::pod_collect_to_vec::<u8, u32>(&bytes));
        self.gpu.queue.write_buffer(buffer, 0, &vec![0; bytes.len()]);
        Ok(())
    }

    /// Begins the totals of a render.
    pub(super) fn finish_totals(&self, totals: &mut Totals, clock: &Clock, started: Instant) -> Result<(), GpuError> {
        totals.device = clock.read(self.gpu)?;
        totals.wall = started.elapsed();
        Ok(())
    }

    /// Runs some steps at once, outside the loop over a whole sample.
    pub(super) fn run_steps(&self, tile: &Tile, frame: Frame, steps: &[Step]) -> Result<(), GpuError> {
        self.write_frame(tile, frame)?;
        let mut runner = Runner { renderer: self, tile, groups: HashMap::new(), under_way: VecDeque::new() };
        if steps.first().is_some_and(|step| step.pass == Pass::Setup) {
            runner.clear_living();
        }
        runner.submit(steps, &mut Clock::new(self.gpu, false))?;
        runner.wait(0)
    }
}

fn stage_of(pass: Pass, scatter_apart: bool) -> Stage {
    match pass {
        Pass::Setup => Stage::Setup,
        Pass::Scatter if scatter_apart => Stage::Scatter,
        Pass::Shade | Pass::Record => Stage::Shade,
        _ => Stage::Advance,
    }
}

/// One sample under way.
struct Runner<'r, 'a> {
    renderer: &'r Renderer<'a>,
    tile: &'r Tile,
    groups: HashMap<(Pass, Slots), BindGroup>,
    under_way: VecDeque<SubmissionIndex>,
}

impl Runner<'_, '_> {
    /// Nothing lives before setup says so.
    fn clear_living(&self) {
        let gpu = self.renderer.gpu;
        let mut encoder = gpu.device.create_command_encoder(&CommandEncoderDescriptor { label: Some("clear") });
        for name in ["living_0", "living_1"] {
            if let Some(buffer) = self.tile.buffer(name) {
                encoder.clear_buffer(buffer, 0, None);
            }
        }
        gpu.queue.submit([encoder.finish()]);
    }

    /// The steps in one submission, those of the same stage that follow each other in one pass.
    fn submit(&mut self, steps: &[Step], clock: &mut Clock) -> Result<(), GpuError> {
        let gpu = self.renderer.gpu;
        for step in steps {
            self.prepare(step)?;
        }
        let mut encoder = gpu.device.create_command_encoder(&CommandEncoderDescriptor { label: None });
        let apart = clock.scatter_apart;
        if let Some(timestamp_writes) = clock.next(gpu, Stage::Start) {
            let descriptor = ComputePassDescriptor { label: None, timestamp_writes: Some(timestamp_writes) };
            drop(encoder.begin_compute_pass(&descriptor));
        }
        for steps in steps.chunk_by(|a, b| stage_of(a.pass, apart) == stage_of(b.pass, apart)) {
            let timestamp_writes = steps.first().and_then(|step| clock.next(gpu, stage_of(step.pass, apart)));
            let mut pass = encoder.begin_compute_pass(&ComputePassDescriptor { label: None, timestamp_writes });
            let mut current = None;
            for step in steps {
                let (Some(pipeline), Some(group)) =
                    (self.renderer.pipelines.get(step.pass), self.groups.get(&(step.pass, step.slots)))
                else {
                    continue;
                };
                if current != Some(step.pass) {
                    pass.set_pipeline(&pipeline.pipeline);
                    current = Some(step.pass);
                }
                pass.set_bind_group(0, group, &self.offsets(step));
                self.dispatch(&mut pass, step);
            }
        }
        self.under_way.push_back(gpu.queue.submit([encoder.finish()]));
        self.wait(IN_FLIGHT)
    }

    fn prepare(&mut self, step: &Step) -> Result<(), GpuError> {
        let key = (step.pass, step.slots);
        let renderer = self.renderer;
        if let (false, Some(pipeline)) = (self.groups.contains_key(&key), renderer.pipelines.get(step.pass)) {
            let group = self.tile.bind_group(renderer.gpu, pipeline, &renderer.buffers, step.slots)?;
            self.groups.insert(key, group);
        }
        Ok(())
    }

    /// Where in the per-pass buffers the step's own parts lie. What a round leaves alive is the next one's work.
    fn offsets(&self, step: &Step) -> Vec<u32> {
        let turn = self.renderer.turns.binary_search(&turn_of(step)).unwrap_or(0) as u64;
        let next = if step.pass == Pass::Setup { 0 } else { step.living + 1 };
        Tile::offsets(&self.renderer.pipelines, step.pass)
            .into_iter()
            .map(|name| match name {
                "turn" => turn,
                "living_in" => step.living,
                _ => next,
            })
            .map(|part| (part * TURN_STRIDE) as u32)
            .collect()
    }

    fn dispatch(&self, pass: &mut wgpu::ComputePass, step: &Step) {
        let living = ["living_0", "living_1"][step.slots.list];
        match (step.dispatch, self.tile.buffer(living)) {
            (Dispatch::Living, Some(buffer)) => pass.dispatch_workgroups_indirect(buffer, step.living * TURN_STRIDE),
            _ => pass.dispatch_workgroups(self.tile.size[0].div_ceil(8), self.tile.size[1].div_ceil(8), 1),
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

/// Storage that a trace adds to its tile.
pub(super) const RECORDS: BufferUsages = BufferUsages::STORAGE;
