//! The files of a render: their content and metadata.

use std::path::{Path, PathBuf};

use super::{Arguments, is_exr};
use crate::cli::continuation::{self, EarlierImage, is_continuable};
use crate::cli::frames::Film;
use crate::cli::paths;
use crate::cli::share::Target;
use crate::cli::watch::PreviewFile;
use crate::error::Error;
use crate::measure::compared_layers;
use crate::output::origin::file_difference;
use crate::output::{FileSettings, ImageWriter, open, settings_of, stores_layers};
use crate::program::Layer;
use crate::render::Window;
use crate::scene::Scene;

impl Arguments {
    /// Returns the files of a target. A band has a single EXR, from which all formats are made when all bands exist.
    pub(in crate::cli) fn paths(&self, target: Target) -> Vec<PathBuf> {
        let all = self.pictures();
        match target.band {
            Some(_) => {
                let main = all.iter().find(|path| is_exr(path)).or(all.first());
                main.map(|path| target.path(path)).into_iter().collect()
            }
            None => all.iter().map(|path| target.path(path)).collect(),
        }
    }

    /// Creates the files of a target, which show this window.
    pub(super) fn open(
        &self,
        scene: &Scene,
        (target, window): (Target, Window),
        layers: &[Layer],
        metadata: &[(String, String)],
    ) -> Result<Vec<Box<dyn ImageWriter>>, Error> {
        let settings = |path: &Path| file_settings(scene, (path, window), layers, metadata);
        self.paths(target).into_iter().map(|path| Ok(open(&path, &settings(&path))?)).collect()
    }

    /// Returns `true` if a target's files exist and match the current settings; otherwise prints the reason for each differing file.
    pub(super) fn is_finished(
        &self,
        scene: &Scene,
        target: Target,
        layers: &[Layer],
        metadata: &[(String, String)],
    ) -> bool {
        self.paths(target).into_iter().all(|path| {
            if !path.exists() {
                return false;
            }
            let why = match settings_of(&path) {
                Ok(found) => {
                    // The borders of bands depend on the compared layers.
                    let window = if target.band.is_some() { found.window } else { self.window(scene) };
                    file_difference(&found, &file_settings(scene, (&path, window), layers, metadata))
                }
                Err(_) => Some("it is not an image from this version of bentray".to_owned()),
            };
            if let Some(why) = &why {
                tell!("{} is rendered again: {why}", path.display());
            }
            why.is_none()
        })
    }

    /// Returns the window that is rendered of an image without bands.
    pub(super) fn window(&self, scene: &Scene) -> Window {
        self.crop.unwrap_or(Window::whole(scene.image.size))
    }

    /// Rejects outputs that would overwrite the scene's files, or that share a file.
    pub(super) fn check_files(&self, film: &Film, targets: &[Target]) -> Result<(), Error> {
        let films = self.output.iter().filter(|path| self.is_film(path)).cloned();
        let outputs = targets.iter().flat_map(|target| self.paths(*target)).chain(films).chain(self.preview.clone());
        let outputs: Vec<PathBuf> = outputs.collect();
        paths::check(outputs.iter().map(PathBuf::as_path), &film.inputs())
    }

    /// Opens all files and discards them, so that a path that cannot be written is found before the work.
    pub(super) fn try_files(&self, still: &Scene, targets: &[Target], layers: &[Layer]) -> Result<(), Error> {
        let window = self.window(still);
        for &target in targets {
            drop(self.open(still, (target, window), layers, &[])?);
        }
        let Some(path) = &self.preview else { return Ok(()) };
        if still.image.adaptive.is_some() {
            return Err(usage!(
                "--preview cannot be combined with image.adaptive, because the pixels do not take their samples in \
                 step"
            ));
        }
        drop(open(path, &file_settings(still, (path, window), layers, &[]))?);
        Ok(())
    }

    /// Creates the file with the unfinished image.
    pub(super) fn preview(
        &self,
        scene: &Scene,
        layers: &[Layer],
        metadata: &[(String, String)],
    ) -> Option<PreviewFile> {
        let path = self.preview.clone()?;
        let settings = file_settings(scene, (&path, self.window(scene)), layers, metadata);
        let settings = move |samples| continuation::after(settings.clone(), samples);
        Some(PreviewFile::new(path, self.preview_every, Box::new(settings)))
    }

    /// Returns advice to request previews, for an image that supports them and has none.
    pub(super) fn preview_advice(&self, scene: &Scene, target: Target) -> Option<String> {
        let has_samples = scene.image.samples > 1 && scene.image.adaptive.is_none();
        let is_still = self.frames.is_none() && target.band.is_none();
        let advised = has_samples && is_still && self.preview.is_none();
        advised.then(|| "help: --preview FILE.png shows the image while it is rendered".to_owned())
    }

    /// Returns the layers in the order of [`Layer::ALL`], each once; none without a file that stores them. The number of samples per pixel is a layer of
    /// adaptive images, unless --layers selects others.
    pub(super) fn layers(&self, scene: &Scene, before: Option<&EarlierImage>) -> Vec<Layer> {
        if !self.output.iter().chain(&self.preview).any(|path| stores_layers(path)) {
            return Vec::new();
        }
        let usual = |layer: Layer| match layer {
            Layer::Redshift => scene.has_frequencies(),
            Layer::ImageOrder => scene.has_orders(),
            layer if layer.is_of_crossings() || layer.is_of_bundles() || layer.is_of_paths() && self.from.is_some() => {
                false
            }
            Layer::Intensity(_) => layer.refused_by(scene).is_none(),
            Layer::OpticalDepth(_) | Layer::MeanRedshift(_) => false,
            Layer::Samples => scene.image.adaptive.is_some(),
            Layer::StandardError => scene.rays.path_tracing.is_some(),
            Layer::Accumulated | Layer::LuminanceM2 => is_continuable(scene),
            _ => before.is_none_or(|before| before.layers().contains(&layer)),
        };
        let keeps =
            |layer: &Layer| self.layers.as_ref().map_or_else(|| usual(*layer), |wanted| wanted.contains(&Some(*layer)));
        Layer::ALL.into_iter().filter(keeps).collect()
    }

    /// Returns the layers that the program keeps. They include the layers that a search compares if the image of `--method-from` had
    /// them, because another program may round differently.
    pub(super) fn kept(&self, scene: &Scene, layers: &[Layer], before: Option<&EarlierImage>) -> Vec<Layer> {
        let is_compared = before.map_or_else(|| self.changes.is_compared(), EarlierImage::is_compared);
        if is_compared { compared_layers(scene, layers) } else { layers.to_owned() }
    }
}

/// Returns the settings of the file at `path`, which shows this window and contains `metadata`.
fn file_settings(
    scene: &Scene,
    (path, window): (&Path, Window),
    layers: &[Layer],
    metadata: &[(String, String)],
) -> FileSettings {
    FileSettings {
        size: scene.image.size,
        window,
        exposure: scene.output.exposure,
        tonemap: scene.output.tonemap,
        bits: scene.output.bits,
        glare: scene.output.glare,
        alpha: scene.is_transparent(),
        layers: if stores_layers(path) { layers.to_vec() } else { Vec::new() },
        metadata: metadata.to_vec(),
    }
}
