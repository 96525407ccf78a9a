//! Prepares a scene for a device: its program, pipelines and data, and the steps of each round of a sample.

use std::borrow::Cow;

use wgpu::ErrorFilter;

use super::grids::LightGrids;
use super::plan::Plan;
use super::schedule::{PassCounts, fused_segments, steps};
use super::submission_size::SubmissionSize;
use super::{RenderError, RenderSettings, Window};
use crate::gpu::{Geometry, Gpu, GpuError, Pipelines, PreviousGeometry, SceneBuffers, pack, schedule_values};
use crate::model::{Control, Value};
use crate::program::{BindingKind, Features, Layout, Mode, Program, ProgramOptions, Regions, Role, Schedule};
use crate::scene::Scene;

/// A scene's program, pipelines and data on a device.
#[derive(Debug)]
pub(super) struct Prepared<'a> {
    pub gpu: &'a Gpu,
    pub scene: Cow<'a, Scene>,
    pub settings: RenderSettings,
    /// The linked program.
    pub program: Program,
    pub pipelines: Pipelines,
    pub buffers: SceneBuffers,
    /// The scenes that samples show in turn while a shutter is open; empty for a still scene.
    pub moments: Vec<Moment>,
    /// The objects that have an interior.
    pub regions: Regions,
    /// The grids of the scene's lights.
    pub grids: LightGrids,
    /// The geometry that the next frame reuses.
    pub before: PreviousGeometry,
    pub max_segments: u32,
    pub passes: PassCounts,
    /// The steps of each round of a sample.
    pub plan: Plan,
    pub submission: SubmissionSize,
    /// The number of images of stars in a tile for which there must be room, because an earlier tile had too little.
    pub star_images: u64,
}

/// A scene that some of an image's samples show, with the same program.
#[derive(Debug)]
pub(super) struct Moment {
    pub scene: Scene,
    pub grids: LightGrids,
    pub buffers: SceneBuffers,
}

impl<'a> Prepared<'a> {
    /// Links and compiles the program, and uploads the scene.
    pub(super) fn new(
        gpu: &'a Gpu,
        mut scene: Cow<'a, Scene>,
        mut settings: RenderSettings,
        grids: LightGrids,
    ) -> Result<Self, RenderError> {
        settings.options.device = gpu.profile;
        // Rays for other purposes than an image end at the surface that they hit.
        if settings.options.mode != Mode::Picture && scene.rays.path_tracing.is_some() {
            scene.to_mut().rays.path_tracing = None;
        }
        let given = settings.options.mode.is_given();
        if !given && scene.camera.is_none() {
            return Err(RenderError::NoCamera);
        }
        if let Some(window) = settings.window.filter(|window| !window.fits(scene.image.size)) {
            return Err(RenderError::Window { window, picture: scene.image.size });
        }
        let geometry = placed(gpu, PreviousGeometry::default(), &scene);
        let stage = gpu.progress.stage("generating the shaders");
        let program = Program::new(&scene, &geometry.analysis, &settings.options, geometry.extent())?;
        drop(stage);
        settings.options.schedule = program.features.schedule;
        let size = settings.window.unwrap_or(Window::whole(scene.image.size)).size;
        let is_picture = settings.options.mode == Mode::Picture;
        let pipelines = Pipelines::new(gpu, &program, if is_picture { size } else { [u32::MAX; 2] })?;
        settings.segments = fused_segments(settings.segments, &program.features, scene.rays.max_segments);
        let segments = settings.segments_a_pass();
        let scope = gpu.device.push_error_scope(ErrorFilter::OutOfMemory);
        let buffers = SceneBuffers::new(gpu, &scene, &geometry, &program, &grids.fields, segments, (None, None))?;
        if let Some(error) = pollster::block_on(scope.pop()) {
            let what = "the scene's objects, images and grids".to_owned();
            return Err(GpuError::Full { what, reason: error.to_string() }.into());
        }
        let max_segments = scene.rays.max_segments;
        let passes = PassCounts::usual();
        let plan = planned(&scene, &program.features, passes, max_segments, settings.segments);
        let regions = geometry.analysis.regions.clone();
        Ok(Self {
            gpu,
            scene,
            settings,
            program,
            pipelines,
            buffers,
            moments: Vec::new(),
            regions,
            grids,
            before: geometry.into_before(),
            max_segments,
            passes,
            plan,
            submission: SubmissionSize::default(),
            star_images: 0,
        })
    }

    /// Replaces the scene by another one with the same program.
    pub(super) fn change_scene(&mut self, mut scene: Scene, grids: LightGrids) -> Result<(), RenderError> {
        let RenderSettings { window, options, .. } = &self.settings;
        if options.mode != Mode::Picture {
            scene.rays.path_tracing = None;
        }
        if let Some(window) = window.filter(|window| !window.fits(scene.image.size)) {
            return Err(RenderError::Window { window, picture: scene.image.size });
        }
        let geometry = placed(self.gpu, std::mem::take(&mut self.before), &scene);
        let program = Program::after(Some(&self.program), &scene, &geometry.analysis, options, geometry.extent())?;
        if !program.runs_as(&self.program) {
            return Err(RenderError::OtherProgram);
        }
        self.grids = grids;
        self.moments.clear();
        let (segments, fields, before) = (self.settings.segments_a_pass(), &self.grids.fields, Some(&self.buffers));
        self.buffers = SceneBuffers::new(self.gpu, &scene, &geometry, &program, fields, segments, (before, None))?;
        self.regions = geometry.analysis.regions.clone();
        self.before = geometry.into_before();
        self.program = program;
        self.max_segments = scene.rays.max_segments;
        self.scene = Cow::Owned(scene);
        self.plan_passes(PassCounts::usual());
        Ok(())
    }

    /// Changes the parameters of the step control and the maximum number of segments of a path. The kind of control stays, and no pass is
    /// recompiled.
    pub(super) fn retune(&mut self, control: Control, max_segments: u32) -> Result<(), GpuError> {
        // Anything that is later derived from the scene must use these values.
        let rays = &mut self.scene.to_mut().rays;
        self.grids.is_outdated |= rays.control != control;
        (rays.control, rays.max_segments) = (control, max_segments);
        self.rewrite("control", &control.values())?;
        self.set_segments(max_segments, self.settings.segments)
    }

    /// Changes the maximum number of segments of a path, and the number of segments of a fused pass.
    pub(super) fn set_segments(&mut self, max_segments: u32, segments: u32) -> Result<(), GpuError> {
        self.max_segments = max_segments;
        self.settings.segments = segments;
        self.rewrite("schedule", &schedule_values(max_segments, self.settings.segments_a_pass()))?;
        self.plan_passes(PassCounts::usual());
        Ok(())
    }

    /// Overwrites the values of one of the scene's uniforms.
    fn rewrite<N: AsRef<str>>(&self, name: &str, values: &[(N, Value)]) -> Result<(), GpuError> {
        for binding in self.program.bindings() {
            let BindingKind::Block { members, .. } = &binding.kind else { continue };
            for member in members.iter().filter(|member| member.value.name == name) {
                let bytes = pack(name, &member.layout, [values])?;
                for buffer in self.all_buffers().filter_map(|scene| scene.buffer(&binding.role)) {
                    self.gpu.queue.write_buffer(buffer, u64::from(member.offset), &bytes);
                }
            }
        }
        Ok(())
    }

    /// Returns the buffers of the scene and of its moments.
    pub(super) fn all_buffers(&self) -> impl Iterator<Item = &SceneBuffers> + Clone {
        std::iter::once(&self.buffers).chain(self.moments.iter().map(|moment| &moment.buffers))
    }

    /// Returns the buffers that a sample shows.
    pub(super) fn buffers_of(&self, sample: u32) -> &SceneBuffers {
        self.moments.get(self.moment_of(sample)).map_or(&self.buffers, |moment| &moment.buffers)
    }

    /// Returns the index of the moment that a sample shows; 0 if there are none.
    pub(super) fn moment_of(&self, sample: u32) -> usize {
        (sample as usize).checked_rem(self.moments.len()).unwrap_or(0)
    }

    /// Returns the layout of the buffer for a binding with this role.
    pub(super) fn layout(&self, role: &Role) -> Result<&Layout, GpuError> {
        self.program.layout(role).ok_or_else(|| GpuError::Layout {
            binding: role.to_string(),
            problem: "the program has no such binding".to_owned(),
        })
    }

    /// Plans these numbers of passes.
    pub(super) fn plan_passes(&mut self, passes: PassCounts) {
        self.passes = passes;
        self.plan = planned(&self.scene, &self.program.features, passes, self.max_segments, self.settings.segments);
    }

    /// Adds passes for rays that outlived theirs: the schedule `whole` is replaced by `fused`, which then gets more passes. Returns `false`
    /// if there are already as many as possible.
    pub(super) fn make_room(&mut self) -> Result<bool, RenderError> {
        if self.is_whole() {
            let options = ProgramOptions { schedule: Schedule::Fused, ..self.settings.options.clone() };
            let settings = RenderSettings { options, ..self.settings.clone() };
            let mut fused = Self::new(self.gpu, self.scene.clone(), settings, self.grids.clone())?;
            fused.take_moments(&self.moments)?;
            *self = fused;
            return Ok(true);
        }
        let Some(more) = self.passes.more(&self.gpu.profile, self.program.features.suspends) else { return Ok(false) };
        self.plan_passes(more);
        Ok(true)
    }

    /// Returns `true` if whole paths are followed in one pass.
    pub(super) fn is_whole(&self) -> bool {
        self.settings.options.schedule == Schedule::Whole
    }
}

/// Returns the plan for each round of a sample.
fn planned(scene: &Scene, features: &Features, passes: PassCounts, max_segments: u32, segments: u32) -> Plan {
    Plan::new(steps(scene, features, passes, max_segments, segments), features.rounds)
}

/// Places the scene's objects and builds the acceleration structure.
fn placed(gpu: &Gpu, before: PreviousGeometry, scene: &Scene) -> Geometry {
    let _stage = gpu.progress.stage("building the acceleration structure");
    Geometry::after(before, scene)
}
