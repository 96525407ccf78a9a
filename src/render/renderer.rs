//! Renders a scene as images, frame after frame.

use std::borrow::Cow;
use std::sync::Arc;

use super::grids::LightGrids;
use super::light_grid::grids_of;
use super::prepared::Prepared;
use super::{LensMap, LightReport, RenderError, RenderSettings};
use crate::gpu::{Gpu, GpuError, Stored, Tile};
use crate::model::Control;
use crate::program::{Mode, PathEnds, Program};
use crate::scene::Scene;

/// A renderer of a scene's images: its program, pipelines and data on a device.
#[derive(Debug)]
pub struct Renderer<'a> {
    pub(super) prepared: Prepared<'a>,
    /// The tile of the previous image, for the next one.
    pub(super) tile: Option<Tile>,
    /// The ends of the paths, if none is followed.
    pub(super) ends: Option<Arc<LensMap>>,
}

impl<'a> Renderer<'a> {
    /// Creates a renderer: creates the grids of lights that have one, links and compiles the program, and uploads the scene.
    ///
    /// # Errors
    ///
    /// Returns [`RenderError::NoCamera`] if the scene has no camera, [`RenderError::Window`] if the window of the settings is not inside
    /// the image, [`RenderError::Program`] if WGSL of the scene is invalid or the scene has too many primitives, and [`RenderError::Gpu`]
    /// if the device lacks a feature or memory. Photon grids can also fail with [`RenderError::LightGrid`] and [`RenderError::LightLost`].
    ///
    /// # Examples
    ///
    /// ```no_run
    /// use bentray::{gpu::Gpu, render::{Renderer, RenderSettings}, scene::Scene};
    ///
    /// let scene = Scene::load("scenes/black_hole.toml".as_ref(), &[])?;
    /// let gpu = Gpu::open(None)?;
    /// let mut renderer = Renderer::new(&gpu, &scene, RenderSettings::default())?;
    /// let picture = renderer.render()?;
    /// assert_eq!(picture.band.width, scene.image.size[0]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(gpu: &'a Gpu, scene: &'a Scene, settings: RenderSettings) -> Result<Self, RenderError> {
        Self::of(gpu, Cow::Borrowed(scene), settings)
    }

    /// Creates a renderer like [`new`](Self::new), which owns its scene.
    ///
    /// # Errors
    ///
    /// Returns the errors of [`new`](Self::new).
    pub fn keeping(gpu: &'a Gpu, scene: Scene, settings: RenderSettings) -> Result<Self, RenderError> {
        Self::of(gpu, Cow::Owned(scene), settings)
    }

    /// Creates a renderer that follows no path, but shades those of a map, which [`map`](Self::map) returned for a scene with the same
    /// camera, rays and surfaces.
    ///
    /// # Errors
    ///
    /// Returns the errors of [`new`](Self::new).
    pub fn of_map(
        gpu: &'a Gpu,
        scene: Scene,
        mut settings: RenderSettings,
        ends: Arc<LensMap>,
    ) -> Result<Self, RenderError> {
        settings.options.ends = PathEnds::Given;
        Ok(Self { ends: Some(ends), ..Self::keeping(gpu, scene, settings)? })
    }

    fn of(gpu: &'a Gpu, scene: Cow<'a, Scene>, mut settings: RenderSettings) -> Result<Self, RenderError> {
        settings.options.mode = Mode::Picture;
        let grids = grids_of(gpu, &scene, &settings)?;
        Ok(Self { prepared: Prepared::new(gpu, scene, settings, grids)?, tile: None, ends: None })
    }

    /// Returns the linked program.
    #[must_use]
    pub fn program(&self) -> &Program {
        &self.prepared.program
    }

    /// Replaces the scene by another one with the same program, such as the next frame of an animation. Its values are uploaded, and no
    /// pass is recompiled.
    ///
    /// # Errors
    ///
    /// Returns [`RenderError::OtherProgram`] if the scene requires other passes than the first one; [`Renderer::new`] can render it.
    pub fn set_scene(&mut self, scene: Scene) -> Result<(), RenderError> {
        let grids = self.grids_for(&scene)?;
        self.prepared.change_scene(scene, grids)
    }

    /// Sets the scenes that the samples of the next image show in turn, starting again after the last, until another scene is set. If
    /// `scenes` is empty, samples show the renderer's scene. Layers of a single ray come from the very first sample.
    ///
    /// # Errors
    ///
    /// Returns [`RenderError::OtherProgram`] if a scene requires other passes than the renderer's scene.
    pub fn set_moments(&mut self, scenes: Vec<Scene>) -> Result<(), RenderError> {
        self.prepared.moments.clear();
        let mut stored = Stored::new();
        for scene in scenes {
            let grids = self.grids_for(&scene)?;
            self.prepared.add_moment(scene, grids, &mut stored)?;
        }
        self.prepared.plan_passes(self.prepared.passes);
        Ok(())
    }

    /// Changes the parameters of the step control and the maximum number of segments of a path. The kind of control stays, and no pass is
    /// recompiled.
    ///
    /// # Errors
    ///
    /// Returns [`GpuError::Layout`] if `control` has other parameters than the control of the scene.
    pub fn retune(&mut self, control: Control, max_segments: u32) -> Result<(), GpuError> {
        self.prepared.retune(control, max_segments)
    }

    /// Returns the reports on the grids of the scene's lights, and of each moment with different light.
    #[must_use]
    pub fn light_reports(&self) -> Vec<&LightReport> {
        let Prepared { grids, moments, .. } = &self.prepared;
        let all = std::iter::once(grids).chain(moments.iter().map(|moment| &moment.grids));
        let mut before: Vec<&LightGrids> = Vec::new();
        for grids in all {
            if !before.iter().any(|other| Arc::ptr_eq(&other.fields, &grids.fields)) {
                before.push(grids);
            }
        }
        before.into_iter().flat_map(|grids| &grids.reports).collect()
    }

    /// Returns the grids for a scene; the grids of the previous moment are reused if the light is unchanged.
    fn grids_for(&self, scene: &Scene) -> Result<LightGrids, RenderError> {
        let Prepared { gpu, scene: own, settings, moments, grids, .. } = &self.prepared;
        let (before, grids) = moments.last().map_or((&**own, grids), |moment| (&moment.scene, &moment.grids));
        let is_kept = !grids.fields.is_empty() && !grids.is_outdated && scene.is_lit_as(before);
        if is_kept { Ok(grids.clone()) } else { grids_of(gpu, scene, settings) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scene(rest: &str) -> Scene {
        let text = format!(
            "[image]\nsize = [16, 12]\n[camera]\nposition = [0, 0, 9]\n[law]\nkind = \"schwarzschild\"\n\
             [rays]\nmethod = \"rk4\"\nbounding_sphere = {{ radius = 20 }}\n[materials.m]\nkind = \"emissive\"\ncolor = [1, 0.5, 0]\n\
             [[objects]]\nshape = \"sphere\"\nmaterial = \"m\"\n{rest}"
        );
        Scene::parse(&text, std::path::Path::new("test.toml"), &[]).unwrap()
    }

    #[test]
    fn another_scene_runs_the_pipelines_that_there_are() {
        let gpu = Gpu::open(None).unwrap();
        let (first, second) = (scene("center = [3, 0, 0]\n"), scene("center = [4, 1, 0]\nradius = 2\n"));
        let fresh = |scene| Renderer::new(&gpu, scene, RenderSettings::default()).unwrap().render().unwrap().band;
        let expected = [fresh(&first), fresh(&second)];
        assert!(expected[0] != expected[1]);
        let mut renderer = Renderer::new(&gpu, &first, RenderSettings::default()).unwrap();
        let compiled = |renderer: &Renderer| -> Vec<_> {
            renderer.prepared.pipelines.iter().map(|(_, pass)| pass.pipeline.clone()).collect()
        };
        let before = compiled(&renderer);
        for (scene, expected) in [(&second, &expected[1]), (&first, &expected[0])] {
            renderer.set_scene(scene.clone()).unwrap();
            assert!(renderer.render().unwrap().band == *expected);
            assert!(compiled(&renderer) == before, "a pass was compiled again");
        }
        // An ellipsoid is another shape than a sphere, so the renderer rejects it and keeps its scene.
        let refused = renderer.set_scene(scene("center = [3, 0, 0]\nscale = [1, 2, 1]\n"));
        assert!(matches!(refused, Err(RenderError::OtherProgram)), "{refused:?}");
        assert!(renderer.render().unwrap().band == expected[0]);
    }

    /// A search for a method renders a small image with other settings, and its renderer then renders the image.
    #[test]
    fn guides_belong_to_the_image_that_they_are_created_for() {
        let gpu = Gpu::open(None).unwrap();
        let of = |size: &str, step: &str| {
            let text = format!(
                "[image]\nsize = {size}\nsamples = 2\n[camera]\nposition = [0, 1, 9]\n[law]\nkind = \"schwarzschild\"\n\
                 [rays]\nmethod = \"rk4\"\nscaled_step = {step}\nbounding_sphere = {{ radius = 20 }}\nlighting = \"path-tracing\"\n\
                 [materials.m]\nkind = \"emissive\"\ncolor = [1, 0.5, 0]\n[materials.floor]\nkind = \"phong\"\ndiffuse = [1, 1, 1]\n\
                 [[objects]]\nshape = \"sphere\"\nmaterial = \"m\"\ncenter = [3, 0, 0]\n\
                 [[objects]]\nshape = \"box\"\nmaterial = \"floor\"\ncenter = [0, -4, 0]\nsize = [20, 1, 20]\n"
            );
            Scene::parse(&text, std::path::Path::new("test.toml"), &[]).unwrap()
        };
        let scene = of("[128, 64]", "0.2");
        let expected = Renderer::new(&gpu, &scene, RenderSettings::default()).unwrap().render().unwrap().band;
        for (size, step) in [("[16, 8]", "0.2"), ("[128, 64]", "0.5")] {
            let other = of(size, step);
            assert!(!other.beams().is_empty());
            let mut renderer = Renderer::new(&gpu, &other, RenderSettings::default()).unwrap();
            renderer.retune(scene.rays.control, scene.rays.max_segments).unwrap();
            renderer.set_scene(scene.clone()).unwrap();
            assert!(renderer.render().unwrap().band == expected, "after {size}, {step}");
        }
    }

    #[test]
    fn pictures_stay_on_the_device_as_long_as_they_are_the_same() {
        let gpu = Gpu::open(None).unwrap();
        let text = "[image]\nsize = [16, 12]\n[camera]\nposition = [0, 0, 9]\n[sky]\nimage = \"data/stars.png\"\n\
                    [rays]\nbounding_sphere = { radius = 20 }\n";
        let first = Scene::parse(text, std::path::Path::new("scenes/test.toml"), &[]).unwrap();
        let mut other = first.clone();
        other.pictures[0].pixels = vec![[0.0, 0.5, 1.0]; first.pictures[0].pixels.len()].into();
        let mut renderer = Renderer::new(&gpu, &first, RenderSettings::default()).unwrap();
        let stars = renderer.render().unwrap().band;
        let before = renderer.prepared.buffers.picture(0).cloned();
        renderer.set_scene(first.clone()).unwrap();
        assert!(renderer.prepared.buffers.picture(0) == before.as_ref() && renderer.render().unwrap().band == stars);
        renderer.set_scene(other.clone()).unwrap();
        let fresh = Renderer::new(&gpu, &other, RenderSettings::default()).unwrap().render().unwrap().band;
        assert!(
            renderer.prepared.buffers.picture(0) != before.as_ref()
                && renderer.render().unwrap().band == fresh
                && fresh != stars
        );
    }
}
