//! Renders motion blur: the samples of an image show several moments of the shutter in turn.
//!
//! *Practice.* All moments run one program. A moment is defined by the scene's buffers alone, and a sample shows it by binding them.
//! Samples are summed on the device as usual. All moments are on the device at once; resources that several share, such as static meshes
//! and textures, are stored once.

use super::RenderError;
use super::grids::LightGrids;
use super::prepared::{Moment, Prepared};
use crate::gpu::{Geometry, GpuError, SceneBuffers, Stored};
use crate::program::Program;
use crate::scene::Scene;

impl Prepared<'_> {
    /// Takes the moments of a renderer of the same scene with another schedule.
    pub(super) fn take_moments(&mut self, moments: &[Moment]) -> Result<(), RenderError> {
        let mut stored = Stored::new();
        moments.iter().try_for_each(|own| self.add_moment(own.scene.clone(), own.grids.clone(), &mut stored))
    }

    /// Uploads the resources of another moment, except those that are already in `stored`.
    pub(super) fn add_moment(
        &mut self,
        scene: Scene,
        grids: LightGrids,
        stored: &mut Stored,
    ) -> Result<(), RenderError> {
        let geometry = Geometry::after(std::mem::take(&mut self.before), &scene);
        let program =
            Program::after(Some(&self.program), &scene, &geometry.analysis, &self.settings.options, geometry.extent())?;
        if !program.runs_as(&self.program) {
            return Err(RenderError::OtherProgram);
        }
        let (segments, there) = (self.settings.segments_a_pass(), (Some(&self.buffers), Some(stored)));
        let scope = self.gpu.device.push_error_scope(wgpu::ErrorFilter::OutOfMemory);
        let buffers = SceneBuffers::new(self.gpu, &scene, &geometry, &program, &grids.fields, segments, there)?;
        if let Some(error) = pollster::block_on(scope.pop()) {
            let what = format!("moment {} of a frame whose shutter is open", self.moments.len());
            return Err(GpuError::Full { what, reason: error.to_string() }.into());
        }
        self.before = geometry.into_before();
        self.moments.push(Moment { scene, grids, buffers });
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::Gpu;
    use crate::program::{ProgramOptions, Schedule};
    use crate::render::{Band, RenderSettings, Renderer};

    fn scene(at: f64) -> Scene {
        let text = format!(
            "[image]\nsize = [16, 12]\nsamples = 8\n[camera]\nposition = [{at}, 0, 9]\n[law]\nkind = \"schwarzschild\"\n[rays]\n\
             method = \"rk4\"\nbounding_sphere = {{ radius = 20 }}\n[sky]\nimage = \"data/stars.png\"\n[materials.m]\nkind = \"emissive\"\n\
             color = [1, 0.5, 0.2]\n[[objects]]\nshape = \"sphere\"\nmaterial = \"m\"\ncenter = [{at}, 2, 0]\n"
        );
        Scene::parse(&text, std::path::Path::new("scenes/test.toml"), &[]).unwrap()
    }

    fn settings(schedule: Schedule, tile_pixels: u64) -> RenderSettings {
        let options = ProgramOptions { schedule, ..ProgramOptions::default() };
        RenderSettings { options, tile_pixels, ..RenderSettings::default() }
    }

    /// Checks that each sample only shows its moment: two scenes in either order contribute as much as each scene alone.
    #[test]
    fn moments_share_the_samples() {
        let gpu = Gpu::open(None).unwrap();
        let [a, b] = [3.0, 3.4].map(scene);
        let mut renderer = Renderer::new(&gpu, &a, settings(Schedule::Fused, u64::MAX)).unwrap();
        let mut of = |moments: &[&Scene]| {
            renderer.set_moments(moments.iter().copied().cloned().collect()).unwrap();
            renderer.render().unwrap().band
        };
        let bands = [of(&[&a, &b]), of(&[&b, &a]), of(&[&a]), of(&[&b]), of(&[])];
        let sharp = Renderer::new(&gpu, &b, settings(Schedule::Fused, u64::MAX)).unwrap().render().unwrap().band;
        assert!(bands[3] == sharp && bands[4] == bands[2] && bands[0] != bands[1]);
        let values = |band: &Band| -> Vec<f32> { band.color.concat() };
        let [ab, ba, aa, bb] = [0, 1, 2, 3].map(|k| values(&bands[k]));
        for i in 0..ab.len() {
            // The sum of eight samples errs by half an ulp of at most 8 each; the mean is an eighth of the sum.
            let bound = 8.0 * f32::EPSILON * ab[i].max(ba[i]).max(1.0);
            assert!((ab[i] + ba[i] - aa[i] - bb[i]).abs() <= bound, "{i}: {} {} {} {}", ab[i], ba[i], aa[i], bb[i]);
        }
    }

    #[test]
    fn schedules_and_tiles_do_not_show() {
        let gpu = Gpu::open(None).unwrap();
        let (first, moments) = (scene(3.0), [3.1, 3.2, 3.3, 3.4].map(scene));
        let of = |schedule, pixels| {
            let mut renderer = Renderer::new(&gpu, &first, settings(schedule, pixels)).unwrap();
            renderer.set_moments(moments.to_vec()).unwrap();
            renderer.render().unwrap().band
        };
        let expected = of(Schedule::Fused, u64::MAX);
        for (schedule, pixels) in
            [(Schedule::Whole, u64::MAX), (Schedule::Segment, u64::MAX), (Schedule::Paper, 64), (Schedule::Fused, 64)]
        {
            assert!(of(schedule, pixels) == expected, "{schedule:?}");
        }
    }

    /// Checks that the resources that moments share are on the device once.
    #[test]
    fn what_stays_is_there_once() {
        let gpu = Gpu::open(None).unwrap();
        let first = scene(3.0);
        let mut renderer = Renderer::new(&gpu, &first, settings(Schedule::Fused, u64::MAX)).unwrap();
        let bytes = |renderer: &Renderer| SceneBuffers::bytes(renderer.prepared.all_buffers());
        let alone = bytes(&renderer);
        // Load files once, like an animation.
        let moment = |at| Scene { pictures: first.pictures.clone(), ..scene(at) };
        renderer.set_moments([3.1, 3.2, 3.3, 3.4].map(moment).to_vec()).unwrap();
        let picture = renderer.prepared.buffers.picture(0).unwrap();
        assert!(renderer.prepared.moments.iter().all(|moment| moment.buffers.picture(0) == Some(picture)));
        assert!(bytes(&renderer) < alone + alone / 2, "{} {alone}", bytes(&renderer));
    }

    #[test]
    fn a_moment_of_another_program_is_refused() {
        let gpu = Gpu::open(None).unwrap();
        let first = scene(3.0);
        let mut other = first.clone();
        other.objects.clear();
        let mut renderer = Renderer::new(&gpu, &first, settings(Schedule::Fused, u64::MAX)).unwrap();
        let refused = renderer.set_moments(vec![first.clone(), other]);
        assert!(matches!(refused, Err(RenderError::OtherProgram)), "{refused:?}");
    }
}
