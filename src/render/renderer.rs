//! A scene made ready for a device.
//!
//! *Length.* Over 300 lines, because all that a prepared scene consists of is made, changed and read in one place.

use std::borrow::Cow;
use std::sync::Arc;
use std::time::Instant;

use wgpu::ErrorFilter;

use super::clock::Clock;
use super::grids::LightGrids;
use super::plan::Plan;
use super::records::Records;
use super::sample::Sample;
use super::schedule::{PassCounts, fused_segments, steps};
use super::{LightReport, RenderError, RenderSettings, Totals, Window};
use crate::gpu::{
    Before, Geometry, Gpu, GpuError, Memory, Pipelines, SECTION, SceneBuffers, Tile, memory, pack, schedule_values,
};
use crate::model::{Control, Value};
use crate::program::{BindingKind, Choice, Features, Layout, Program, Purpose, Regions, Role, Schedule};
use crate::scene::Scene;

/// A scene's program, pipelines and data on a device.
#[derive(Debug)]
pub struct Renderer<'a> {
    pub(super) gpu: &'a Gpu,
    pub(super) scene: Cow<'a, Scene>,
    pub(super) settings: RenderSettings,
    /// The linked program.
    pub program: Program,
    pub(super) pipelines: Pipelines,
    pub(super) buffers: SceneBuffers,
    /// What samples show in turn instead, if anything: the moments while a shutter is open.
    pub(super) moments: Vec<Moment>,
    /// Which objects have an inside.
    pub(super) regions: Regions,
    /// Of the scene's lights.
    pub(super) grids: LightGrids,
    /// Kept for the next frame.
    pub(super) before: Before,
    pub(super) max_segments: u32,
    pub(super) passes: PassCounts,
    /// What runs for each round of a sample.
    pub(super) plan: Plan,
}

/// A scene that some of a picture's samples show, of the same program.
#[derive(Debug)]
pub(super) struct Moment {
    pub scene: Scene,
    pub grids: LightGrids,
    pub buffers: SceneBuffers,
}

/// What became of a tile.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum TileEnd {
    Done,
    /// Rays were still under way when the passes ended. There is more room for them now, and the tile is to be rendered again.
    Again,
}

impl<'a> Renderer<'a> {
    /// Links, compiles and uploads.
    pub(super) fn of(
        gpu: &'a Gpu,
        mut scene: Cow<'a, Scene>,
        mut settings: RenderSettings,
        grids: LightGrids,
    ) -> Result<Self, RenderError> {
        settings.choice.device = gpu.profile;
        // Whatever rays are followed for besides a picture, they end where they meet a surface.
        if settings.choice.purpose != Purpose::Picture && scene.rays.paths.is_some() {
            scene.to_mut().rays.paths = None;
        }
        let given = settings.choice.purpose.is_given();
        if !given && scene.camera.is_none() {
            return Err(RenderError::NoCamera);
        }
        if let Some(window) = settings.window.filter(|window| !window.fits(scene.image.size)) {
            return Err(RenderError::Window { window, picture: scene.image.size });
        }
        let geometry = placed(gpu, Before::default(), &scene);
        let stage = gpu.progress.stage("generating the shaders");
        let program = Program::new(&scene, &geometry.analysis, &settings.choice, geometry.extent())?;
        drop(stage);
        settings.choice.schedule = program.features.schedule;
        let [width, _] = settings.window.unwrap_or(Window::whole(scene.image.size)).size;
        let is_picture = settings.choice.purpose == Purpose::Picture;
        let pipelines = Pipelines::new(gpu, &program, if is_picture { width } else { u32::MAX })?;
        settings.segments = fused_segments(settings.segments, &program.features, scene.rays.max_segments);
        let segments = settings.segments_a_pass();
        let scope = gpu.device.push_error_scope(ErrorFilter::OutOfMemory);
        let buffers = SceneBuffers::new(gpu, &scene, &geometry, &program, &grids.fields, segments, (None, None))?;
        if let Some(error) = pollster::block_on(scope.pop()) {
            let what = "the scene's objects, pictures and grids".to_owned();
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
        })
    }

    /// Goes on with another scene of the same program.
    pub(super) fn change_scene(&mut self, mut scene: Scene, grids: LightGrids) -> Result<(), RenderError> {
        let RenderSettings { window, choice, .. } = &self.settings;
        if choice.purpose != Purpose::Picture {
            scene.rays.paths = None;
        }
        if let Some(window) = window.filter(|window| !window.fits(scene.image.size)) {
            return Err(RenderError::Window { window, picture: scene.image.size });
        }
        let geometry = placed(self.gpu, std::mem::take(&mut self.before), &scene);
        let program = Program::after(Some(&self.program), &scene, &geometry.analysis, choice, geometry.extent())?;
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

    /// Changes the numbers of the step control and the segments that a path may have; which control it is stays, and no pass
    /// is compiled again.
    pub fn retune(&mut self, control: Control, max_segments: u32) -> Result<(), GpuError> {
        // What is made of the scene later is made with these.
        let rays = &mut self.scene.to_mut().rays;
        (rays.control, rays.max_segments) = (control, max_segments);
        self.rewrite("control", &control.values())?;
        self.set_segments(max_segments, self.settings.segments)
    }

    /// Changes how many segments a path may have, and how many of them a fused pass takes.
    pub(super) fn set_segments(&mut self, max_segments: u32, segments: u32) -> Result<(), GpuError> {
        self.max_segments = max_segments;
        self.settings.segments = segments;
        self.rewrite("schedule", &schedule_values(max_segments, self.settings.segments_a_pass()))?;
        self.plan_passes(PassCounts::usual());
        Ok(())
    }

    /// Gives one of the scene's uniforms other values.
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

    /// The scene's own buffers, and those of its moments.
    pub(super) fn all_buffers(&self) -> impl Iterator<Item = &SceneBuffers> + Clone {
        std::iter::once(&self.buffers).chain(self.moments.iter().map(|moment| &moment.buffers))
    }

    /// What a sample shows.
    pub(super) fn buffers_of(&self, sample: u32) -> &SceneBuffers {
        let moment = (sample as usize).checked_rem(self.moments.len()).map(|k| &self.moments[k]);
        moment.map_or(&self.buffers, |moment| &moment.buffers)
    }

    /// What making the grids of the scene's lights came to; where each moment has its own, of all of them.
    #[must_use]
    pub fn light_reports(&self) -> Vec<&LightReport> {
        let all = std::iter::once(&self.grids).chain(self.moments.iter().map(|moment| &moment.grids));
        let mut before: Vec<&LightGrids> = Vec::new();
        for grids in all {
            if !before.iter().any(|other| Arc::ptr_eq(&other.fields, &grids.fields)) {
                before.push(grids);
            }
        }
        before.into_iter().flat_map(|grids| &grids.reports).collect()
    }

    /// What each pixel costs on the device.
    #[must_use]
    pub fn memory(&self) -> Memory {
        memory(&self.program)
    }

    /// A tile of this program's state.
    pub(super) fn tile(&self, size: [u32; 2]) -> Result<Tile, GpuError> {
        let scope = self.gpu.device.push_error_scope(ErrorFilter::OutOfMemory);
        let plan = &self.plan;
        let tile = Tile::new(self.gpu, &self.program, size, &plan.sections())?;
        if let Some(error) = pollster::block_on(scope.pop()) {
            let what = format!("a tile of {}×{} pixels", size[0], size[1]);
            return Err(GpuError::Full { what, reason: error.to_string() });
        }
        if let Some(layout) = self.program.layout(&Role::Parameters) {
            for (i, parameters) in plan.parameters.iter().enumerate() {
                let bytes = pack("dispatch parameters", layout, [parameters.row()])?;
                tile.write(self.gpu, &Role::Parameters, i as u64 * SECTION, &bytes);
            }
        }
        Ok(tile)
    }

    /// How the buffer for a binding of this role lies.
    pub(super) fn layout(&self, role: &Role) -> Result<&Layout, GpuError> {
        self.program.layout(role).ok_or_else(|| GpuError::Layout {
            binding: role.to_string(),
            problem: "the program does not bind it".to_owned(),
        })
    }

    pub(super) fn write_sample(&self, tile: &Tile, sample: Sample, round: u32) -> Result<(), GpuError> {
        let Some(layout) = self.program.layout(&Role::Frame) else { return Ok(()) };
        tile.write(self.gpu, &Role::Frame, 0, &pack("frame", layout, [sample.row(tile.size, round)])?);
        Ok(())
    }

    /// Records so many passes from now on.
    pub(super) fn plan_passes(&mut self, passes: PassCounts) {
        self.passes = passes;
        self.plan = planned(&self.scene, &self.program.features, passes, self.max_segments, self.settings.segments);
    }

    /// Adds the tile's tally to `totals`, and clears it. Returns `true` if rays are still under way.
    ///
    /// `rays` is how many there are, where that is known beforehand: a device that stops an invocation for its loops says nothing,
    /// and what a pass of whole paths then left out is only missing from the count.
    pub(super) fn add_tally(&self, tile: &Tile, totals: &mut Totals, rays: Option<u64>) -> Result<bool, GpuError> {
        let records = Records::take(self.gpu, &self.program, tile, &Role::Tally)?;
        let Some(tally) = records.rows().next() else { return Ok(false) };
        totals.add_tally(&tally);
        let missing = self.is_whole() && rays.is_some_and(|rays| Totals::counted(&tally) < rays);
        Ok(missing || Totals::unfinished(&tally) > 0)
    }

    /// As [`add_tally`](Self::add_tally), unless rays are still under way for which there can be more room.
    pub(super) fn read_tally(
        &mut self,
        tile: &Tile,
        totals: &mut Totals,
        rays: Option<u64>,
    ) -> Result<TileEnd, RenderError> {
        let before = totals.clone();
        if self.add_tally(tile, totals, rays)? && self.make_room()? {
            *totals = before;
            return Ok(TileEnd::Again);
        }
        Ok(TileEnd::Done)
    }

    /// Makes room for rays that outlived the passes that were to follow them: whole paths are followed by the schedule `fused` from now on, and
    /// that has more passes. Returns `false` if there is as much room as there can be.
    pub(super) fn make_room(&mut self) -> Result<bool, RenderError> {
        if self.is_whole() {
            let choice = Choice { schedule: Schedule::Fused, ..self.settings.choice.clone() };
            let settings = RenderSettings { choice, ..self.settings.clone() };
            let mut fused = Self::of(self.gpu, self.scene.clone(), settings, self.grids.clone())?;
            fused.take_moments(&self.moments)?;
            *self = fused;
            return Ok(true);
        }
        let Some(more) = self.passes.more(&self.gpu.profile, self.program.features.suspends) else { return Ok(false) };
        self.plan_passes(more);
        Ok(true)
    }

    /// Are paths followed in one pass?
    pub(super) fn is_whole(&self) -> bool {
        self.settings.choice.schedule == Schedule::Whole
    }

    /// Adds the time that the device and the host took.
    pub(super) fn finish_totals(&self, totals: &mut Totals, clock: &Clock, started: Instant) -> Result<(), GpuError> {
        totals.device = clock.read(self.gpu)?;
        totals.wall = started.elapsed();
        Ok(())
    }
}

/// What runs for each round of a sample.
fn planned(scene: &Scene, features: &Features, passes: PassCounts, max_segments: u32, segments: u32) -> Plan {
    Plan::new(steps(scene, features, passes, max_segments, segments), features.rounds)
}

/// Places a scene's objects, and builds what is searched for them.
fn placed(gpu: &Gpu, before: Before, scene: &Scene) -> Geometry {
    let _stage = gpu.progress.stage("building the acceleration structure");
    Geometry::after(before, scene)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scene(rest: &str) -> Scene {
        let text = format!(
            "[image]\nsize = [16, 12]\n[camera]\nposition = [0, 0, 9]\n[law]\nkind = \"schwarzschild\"\n\
             [rays]\nmethod = \"rk4\"\nbound = {{ radius = 20 }}\n[materials.m]\nkind = \"emissive\"\ncolor = [1, 0.5, 0]\n\
             [[objects]]\nshape = \"sphere\"\nmaterial = \"m\"\n{rest}"
        );
        Scene::parse(&text, std::path::Path::new("test.toml"), &[]).unwrap()
    }

    #[test]
    fn another_scene_runs_the_pipelines_that_there_are() {
        let gpu = Gpu::open(None).unwrap();
        let (first, second) = (scene("center = [3, 0, 0]\n"), scene("center = [4, 1, 0]\nradius = 2\n"));
        let fresh = |scene| Renderer::new(&gpu, scene, RenderSettings::default()).unwrap().picture().unwrap().band;
        let expected = [fresh(&first), fresh(&second)];
        assert!(expected[0] != expected[1]);
        let mut renderer = Renderer::new(&gpu, &first, RenderSettings::default()).unwrap();
        let compiled = |renderer: &Renderer| -> Vec<_> {
            renderer.pipelines.iter().map(|(_, pass)| pass.pipeline.clone()).collect()
        };
        let before = compiled(&renderer);
        for (scene, expected) in [(&second, &expected[1]), (&first, &expected[0])] {
            renderer.set_scene(scene.clone()).unwrap();
            assert!(renderer.picture().unwrap().band == *expected);
            assert!(compiled(&renderer) == before, "a pass was compiled again");
        }
        // A stretched sphere is another shape: it is refused, and what there was goes on.
        let refused = renderer.set_scene(scene("center = [3, 0, 0]\nscale = [1, 2, 1]\n"));
        assert!(matches!(refused, Err(RenderError::OtherProgram)), "{refused:?}");
        assert!(renderer.picture().unwrap().band == expected[0]);
    }

    #[test]
    fn pictures_stay_on_the_device_as_long_as_they_are_the_same() {
        let gpu = Gpu::open(None).unwrap();
        let text = "[image]\nsize = [16, 12]\n[camera]\nposition = [0, 0, 9]\n[sky]\nimage = \"data/stars.png\"\n\
                    [rays]\nbound = { radius = 20 }\n";
        let first = Scene::parse(text, std::path::Path::new("scenes/test.toml"), &[]).unwrap();
        let mut other = first.clone();
        other.pictures[0].pixels = vec![[0.0, 0.5, 1.0]; first.pictures[0].pixels.len()].into();
        let mut renderer = Renderer::new(&gpu, &first, RenderSettings::default()).unwrap();
        let stars = renderer.picture().unwrap().band;
        let before = renderer.buffers.picture(0).cloned();
        renderer.set_scene(first.clone()).unwrap();
        assert!(renderer.buffers.picture(0) == before.as_ref() && renderer.picture().unwrap().band == stars);
        renderer.set_scene(other.clone()).unwrap();
        let fresh = Renderer::new(&gpu, &other, RenderSettings::default()).unwrap().picture().unwrap().band;
        assert!(
            renderer.buffers.picture(0) != before.as_ref()
                && renderer.picture().unwrap().band == fresh
                && fresh != stars
        );
    }
}
