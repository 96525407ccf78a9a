//! The state of a scene: its renderer and tracer, which compile their programs once, and the integration methods that were chosen.

use std::sync::Arc;

use bentray::measure::profile::{self, Emission};
use bentray::measure::{
    EndJacobian, OpticalPath, Preparation, Verification, calibrate, compared_layers, jacobians, optical_paths, verify,
};
use bentray::program::{Layer, Mode, PathEnds};
use bentray::render::{
    Band, Crossings, LensMap, RenderError, RenderSettings, Renderer, Starts, Traced, Tracer, trace_paths,
};
use bentray::scene::{Files, Override, Rays, Scene as Checked};

use crate::device::Device;

/// The parts of a scene that change.
pub struct State {
    /// The changes since the text, by their keys.
    pub changes: Vec<(String, Override)>,
    pub files: Files,
    pub scene: Checked,
    /// The renderer of the last image, and the layers that it has compiled.
    image: Option<(Renderer<'static>, Vec<Layer>)>,
    /// The integration of images, once it is chosen.
    image_rays: Option<Chosen>,
    pub tracer: Option<Tracer<'static>>,
    /// The renderer of the last image from a map, with the map and the layers that it has compiled.
    shader: Option<(Renderer<'static>, Arc<LensMap>, Vec<Layer>)>,
    /// The integration of traced rays, once it is chosen.
    traced_rays: Option<Chosen>,
}

/// A choice of the integration, which changes of other keys keep.
#[derive(Clone)]
struct Chosen {
    asked: Rays,
    rays: Rays,
    /// Is `true` if the layers that a search compares are compiled, which determine how the device rounds.
    compared: bool,
}

impl State {
    /// Creates the state of a scene without changes.
    pub fn new(files: Files, scene: Checked) -> Self {
        Self {
            changes: Vec::new(),
            files,
            scene,
            image: None,
            image_rays: None,
            tracer: None,
            shader: None,
            traced_rays: None,
        }
    }

    /// Returns the integration of images or, before the first one, of traced rays, once it is chosen.
    pub fn rays(&self) -> Option<&Rays> {
        let given = self.scene.rays.auto.is_none().then_some(&self.scene.rays);
        given.or(self.image_rays.as_ref().or(self.traced_rays.as_ref()).map(|chosen| &chosen.rays))
    }

    /// Renders an image, and chooses the method of the first one.
    pub fn draw(&mut self, device: Device, mut scene: Checked, layers: &[Layer]) -> Result<Band, RenderError> {
        let settings = self.settle(device, &mut scene, layers)?;
        self.image = self.image.take().filter(|(_, compiled)| *compiled == settings.options.layers);
        let kept = self.image.as_mut().map(|(renderer, _)| renderer.set_scene(scene.clone()));
        match kept {
            Some(Ok(())) => {}
            Some(Err(RenderError::OtherProgram)) | None => {
                let compiled = settings.options.layers.clone();
                self.image = Some((Renderer::keeping(device.gpu, scene, settings)?, compiled));
            }
            Some(Err(error)) => return Err(error),
        }
        let Some((renderer, _)) = &mut self.image else { return Err(RenderError::NoCamera) };
        Ok(renderer.render()?.band)
    }

    /// Sets the method of images, which is chosen for the first one, and returns the settings for these layers.
    fn settle(&mut self, device: Device, scene: &mut Checked, layers: &[Layer]) -> Result<RenderSettings, RenderError> {
        let mut settings = RenderSettings::default();
        settings.options.layers = layers.to_vec();
        if scene.rays.auto.is_some() {
            let kept = self.image_rays.as_ref().filter(|chosen| chosen.asked == scene.rays);
            let chosen = match kept {
                Some(chosen) => chosen.clone(),
                None => self.choose(device, scene, &settings)?,
            };
            scene.rays.clone_from(&chosen.rays);
            if chosen.compared {
                settings.options.layers = compared_layers(scene, layers);
            }
        }
        Ok(settings)
    }

    /// Follows the rays of an image, and returns their ends with the integration.
    pub fn map(&mut self, device: Device) -> Result<(LensMap, Rays), RenderError> {
        let mut scene = self.scene.clone();
        let mut settings = self.settle(device, &mut scene, &[])?;
        settings.options.ends = PathEnds::Stored;
        let rays = scene.rays.clone();
        let (map, ..) = Renderer::keeping(device.gpu, scene, settings)?.map()?;
        Ok((map, rays))
    }

    /// Renders an image from the ends of its rays.
    pub fn shade(
        &mut self,
        device: Device,
        scene: Checked,
        map: &Arc<LensMap>,
        layers: &[Layer],
    ) -> Result<Band, RenderError> {
        let is_kept = |(_, own, compiled): &(_, Arc<LensMap>, Vec<Layer>)| Arc::ptr_eq(own, map) && compiled == layers;
        self.shader = self.shader.take().filter(is_kept);
        let kept = self.shader.as_mut().map(|(renderer, ..)| renderer.set_scene(scene.clone()));
        match kept {
            Some(Ok(())) => {}
            Some(Err(RenderError::OtherProgram)) | None => {
                let mut settings = RenderSettings::default();
                settings.options.layers = layers.to_vec();
                let renderer = Renderer::of_map(device.gpu, scene, settings, map.clone())?;
                self.shader = Some((renderer, map.clone(), layers.to_vec()));
            }
            Some(Err(error)) => return Err(error),
        }
        let Some((renderer, ..)) = &mut self.shader else { return Err(RenderError::NoCamera) };
        Ok(renderer.render()?.band)
    }

    /// Compares random pixels of the image with a reference solution in 64 bits.
    pub fn verify(&mut self, device: Device, count: usize) -> Result<Verification, RenderError> {
        let mut scene = self.scene.clone();
        let settings = self.settle(device, &mut scene, &[])?;
        verify(device.gpu, &scene, &settings, count)
    }

    /// Searches for a method, and keeps the renderer that the search has compiled.
    fn choose(&mut self, device: Device, scene: &Checked, settings: &RenderSettings) -> Result<Chosen, RenderError> {
        let rays = scene.image.size.map(u64::from).iter().product::<u64>() * u64::from(scene.image.samples);
        let mut chosen = Chosen { asked: scene.rays.clone(), rays: scene.rays.clone(), compared: false };
        if let Some(prepared) = Preparation::new(device.gpu, scene, settings)? {
            let (calibration, renderer) = prepared.choose(rays)?;
            if let Some(calibration) = calibration {
                chosen.rays = calibration.applied(scene).rays;
                chosen.compared = calibration.layers != settings.options.layers;
                self.image = renderer.map(|renderer| (renderer, calibration.layers));
            }
        }
        self.image_rays = Some(chosen.clone());
        Ok(chosen)
    }

    /// Follows rays, and chooses the method for the first ones.
    pub fn follow(&mut self, device: Device, rays: &[[f64; 6]]) -> Result<Vec<Traced>, RenderError> {
        if rays.is_empty() {
            return Ok(Vec::new());
        }
        if self.tracer.is_none() {
            let scene = self.for_rays(device, rays)?;
            self.tracer = Some(Tracer::keeping(device.gpu, scene, RenderSettings::default(), Mode::Trace)?);
        }
        let Some(tracer) = &mut self.tracer else { return Err(RenderError::NoCamera) };
        Ok(tracer.follow(Starts::Given(rays))?.0)
    }

    /// Follows rays like [`follow`](Self::follow), and returns the points of their paths.
    pub fn paths(&mut self, device: Device, rays: &[[f64; 6]]) -> Result<Vec<Vec<[f64; 3]>>, RenderError> {
        if rays.is_empty() {
            return Ok(Vec::new());
        }
        let scene = self.for_rays(device, rays)?;
        let paths = trace_paths(device.gpu, &scene, &RenderSettings::default(), rays)?;
        Ok(paths.into_iter().map(|(_, points)| points.into_iter().map(|point| point.x).collect()).collect())
    }

    /// Follows rays like [`follow`](Self::follow), and returns their crossings of translucent surfaces.
    pub fn crossings(&mut self, device: Device, rays: &[[f64; 6]]) -> Result<Vec<Crossings>, RenderError> {
        if rays.is_empty() {
            return Ok(Vec::new());
        }
        let scene = self.for_rays(device, rays)?;
        let mut settings = RenderSettings::default();
        settings.options.layers = vec![Layer::CrossingRadius];
        let mut tracer = Tracer::keeping(device.gpu, scene, settings, Mode::Trace)?;
        tracer.follow(Starts::Given(rays))?;
        let crossings = tracer.crossings();
        // Without objects there are none.
        Ok((0..rays.len()).map(|ray| crossings.get(ray).copied().unwrap_or_default()).collect())
    }

    /// Follows rays like [`follow`](Self::follow), and returns how their ends change with their starts.
    pub fn jacobians(&mut self, device: Device, rays: &[[f64; 6]]) -> Result<Vec<EndJacobian>, RenderError> {
        if rays.is_empty() {
            return Ok(Vec::new());
        }
        let scene = self.for_rays(device, rays)?;
        Ok(jacobians(device.gpu, &scene, &RenderSettings::default(), rays)?.0)
    }

    /// Follows rays in 64 bits, and returns the lengths of their paths.
    pub fn optical_paths(&mut self, device: Device, rays: &[[f64; 6]]) -> Result<Vec<OpticalPath>, RenderError> {
        if rays.is_empty() {
            return Ok(Vec::new());
        }
        optical_paths(device.gpu, &self.scene, &RenderSettings::default(), rays)
    }

    /// Returns the light of each crossing of a surface in the image.
    pub fn emissions(&mut self, device: Device, objects: Option<&[u32]>) -> Result<Vec<Emission>, RenderError> {
        let mut scene = self.scene.clone();
        let settings = self.settle(device, &mut scene, &[])?;
        Ok(profile::emissions(device.gpu, &scene, &settings, objects)?.0)
    }

    /// Returns the scene with the method of traced rays, which is chosen for the first ones.
    fn for_rays(&mut self, device: Device, rays: &[[f64; 6]]) -> Result<Checked, RenderError> {
        let mut scene = self.scene.clone();
        if scene.rays.auto.is_some() {
            let kept = self.traced_rays.take().filter(|chosen| chosen.asked == scene.rays);
            let chosen = match kept {
                Some(chosen) => chosen,
                None => {
                    let found = calibrate(device.gpu, &scene, &RenderSettings::default(), Some(rays))?;
                    let applied = found.map_or(scene.rays.clone(), |found| found.applied(&scene).rays);
                    Chosen { asked: scene.rays.clone(), rays: applied, compared: false }
                }
            };
            scene.rays.clone_from(&chosen.rays);
            self.traced_rays = Some(chosen);
        }
        Ok(scene)
    }
}
