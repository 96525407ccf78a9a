//! `--continue`: adds samples to an image that was rendered before, from its own EXR.
//!
//! *Idea.* The ray of a path depends only on its pixel and its sample number, and the file stores the sums of its samples bit for bit. So
//! further samples give the image of one longer render, if the scene is unchanged: the file identifies the scene, and the method that
//! followed its rays.

use std::path::{Path, PathBuf};

use super::frames::Film;
use super::origin::origin;
use crate::error::Error;
use crate::gpu::Gpu;
use crate::output::origin::{COMPARED, FOLLOWED, SAMPLES, difference};
use crate::output::{FileSettings, OutputError, picture};
use crate::program::Layer;
use crate::render::{Band, EarlierSamples, Window};
use crate::scene::{SamplePattern, Scene};

/// The metadata of an image that may change when it is continued.
const MAY_DIFFER: [&str; 1] = [SAMPLES];

/// The layers from which an image is continued.
pub(super) const SUMS: [Layer; 2] = [Layer::Accumulated, Layer::LuminanceM2];

/// Returns `true` if an image of this scene can be continued, provided that its file keeps the sums.
pub(super) fn is_continuable(scene: &Scene) -> bool {
    scene.rays.path_tracing.is_some() && scene.image.adaptive.is_none()
}

/// Returns the file settings after `samples` samples, where `settings` are those of the finished image.
pub(super) fn after(mut settings: FileSettings, samples: u32) -> FileSettings {
    if let Some((_, text)) = settings.metadata.iter_mut().find(|(key, _)| key == SAMPLES) {
        *text = samples.to_string();
    }
    settings
}

/// An image to continue.
pub(super) struct EarlierImage {
    path: PathBuf,
    settings: FileSettings,
    band: Band,
    samples: u32,
    followed: String,
}

impl EarlierImage {
    /// Reads an image that keeps its sums.
    pub(super) fn read(path: &Path) -> Result<Self, Error> {
        let problem = "it has no layers `accumulated` and `luminance_m2` to continue from; EXRs of images with lighting = \
                       \"path-tracing\" have them";
        let none = || OutputError::Part { path: path.to_owned(), problem: problem.to_owned() };
        let (settings, band) = picture(path)?;
        let has_sums = SUMS.iter().all(|layer| settings.layers.contains(layer));
        let samples = settings.said(SAMPLES).and_then(|samples| samples.parse().ok()).filter(|_| has_sums);
        let followed = settings.said(FOLLOWED).map(str::to_owned);
        let (samples, followed) = (samples.ok_or_else(none)?, followed.ok_or_else(none)?);
        Ok(Self { path: path.to_owned(), settings, band, samples, followed })
    }

    /// Loads the scene, with the integration method of the image.
    pub(super) fn load(&self, film: &Film) -> Result<Scene, Error> {
        Ok(film.load_as(None, &self.followed)?)
    }

    fn wrong(&self, problem: &str) -> Result<(), Error> {
        Err(usage!("--continue {}: {problem}", self.path.display()))
    }

    /// Rejects an image from another scene, method, device or version of bentray.
    pub(super) fn check_origin(&self, film: &Film, gpu: &Gpu, scene: &Scene) -> Result<(), Error> {
        let own = film.load(None)?.rays;
        if own.auto.is_none() && own.followed() != self.followed {
            let [followed, own] = [&self.followed, &own.followed()];
            return self.wrong(&format!(
                "its integration method is {followed}, but this render uses {own}; remove the method from the scene, \
                 or start a new render"
            ));
        }
        let made = origin(film, None, gpu, scene)?;
        if let Some(found) = difference([&self.settings.metadata, &made], &MAY_DIFFER) {
            return self.wrong(&format!("{found}; only `samples` and [output] may differ"));
        }
        Ok(())
    }

    /// Rejects an image that a longer render of the scene, with these layers and this window, would not have started with.
    pub(super) fn check(&self, scene: &Scene, layers: &[Layer], window: Window) -> Result<(), Error> {
        let wrong = |problem: String| self.wrong(&problem);
        if self.samples == 1 {
            return wrong(
                "it has one sample per pixel, at the center, which other renders do not use; start a new render"
                    .to_owned(),
            );
        }
        if scene.image.sampler == SamplePattern::MultiJittered {
            return wrong("multi-jittered samples require a fixed number of samples; remove `sampler`".to_owned());
        }
        if self.settings.window != window {
            return wrong(format!("it shows the window {}, but this render shows {window}", self.settings.window));
        }
        if self.samples >= scene.image.samples {
            let [has, more] = [self.samples, 2 * self.samples];
            let asked = scene.image.samples;
            return wrong(format!(
                "it has {has} samples per pixel already, and {asked} are requested; request more, such as --samples \
                 {more}"
            ));
        }
        let missing = |layer: &&Layer| layer.is_of_a_ray() && !self.settings.layers.contains(layer);
        match layers.iter().find(missing) {
            Some(layer) => wrong(format!(
                "it has no layer `{}`, which stores the first sample of each pixel; remove it from --layers",
                layer.name()
            )),
            None => Ok(()),
        }
    }

    /// Returns the layers of the image.
    pub(super) fn layers(&self) -> &[Layer] {
        &self.settings.layers
    }

    /// Returns `true` if its program kept the layers that a search compares.
    pub(super) fn is_compared(&self) -> bool {
        self.settings.said(COMPARED) == Some("true")
    }

    /// Returns the sums from which the render continues.
    pub(super) fn earlier(self) -> EarlierSamples {
        EarlierSamples { samples: self.samples, band: self.band }
    }
}
