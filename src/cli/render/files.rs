//! The files of a render: what each holds, and what it says of itself.

use std::path::{Path, PathBuf};

use super::{Arguments, is_exr};
use crate::cli::frames::Film;
use crate::cli::go_on::{self, Before, is_continuable};
use crate::cli::paths;
use crate::cli::share::Target;
use crate::cli::watch::PreviewFile;
use crate::error::Error;
use crate::measure::compared_layers;
use crate::output::origin::file_difference;
use crate::output::{FileSettings, ImageWriter, open, settings_of};
use crate::program::Layer;
use crate::render::Window;
use crate::scene::Scene;

impl Arguments {
    /// The files of a target. A band has one alone, an EXR, from which files of any format are made when all bands are there.
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

    /// Begins the files of a target, which show this window.
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

    /// Are a target's files there, made by what would make them now? Files of something else are named.
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
                    // Where bands are cut follows from what is compared.
                    let window = if target.band.is_some() { found.window } else { self.window(scene) };
                    file_difference(&found, &file_settings(scene, (&path, window), layers, metadata))
                }
                Err(_) => Some("it is no picture of this version of bentray".to_owned()),
            };
            if let Some(why) = &why {
                tell!("{} is rendered again: {why}", path.display());
            }
            why.is_none()
        })
    }

    /// What is rendered of a picture that is not cut into bands.
    pub(super) fn window(&self, scene: &Scene) -> Window {
        self.crop.unwrap_or(Window::whole(scene.image.size))
    }

    /// Refuses to write over the scene's own files, or two things to one file.
    pub(super) fn check_files(&self, film: &Film, targets: &[Target]) -> Result<(), Error> {
        let films = self.output.iter().filter(|path| self.is_film(path)).cloned();
        let outputs = targets.iter().flat_map(|target| self.paths(*target)).chain(films).chain(self.preview.clone());
        let outputs: Vec<PathBuf> = outputs.collect();
        paths::check(outputs.iter().map(PathBuf::as_path), &film.inputs())
    }

    /// Opens all files and drops them again: a path that cannot be written is found before the work.
    pub(super) fn try_files(&self, still: &Scene, targets: &[Target], layers: &[Layer]) -> Result<(), Error> {
        let window = self.window(still);
        for &target in targets {
            drop(self.open(still, (target, window), layers, &[])?);
        }
        let Some(path) = &self.preview else { return Ok(()) };
        if still.image.adaptive.is_some() {
            return Err(usage!(
                "--preview: an adaptive picture has none, for its pixels do not take their samples together"
            ));
        }
        drop(open(path, &file_settings(still, (path, window), layers, &[]))?);
        Ok(())
    }

    /// The file that shows the picture while it is rendered.
    pub(super) fn preview(
        &self,
        scene: &Scene,
        layers: &[Layer],
        metadata: &[(String, String)],
    ) -> Option<PreviewFile> {
        let path = self.preview.clone()?;
        let settings = file_settings(scene, (&path, self.window(scene)), layers, metadata);
        let settings = move |samples| go_on::after(settings.clone(), samples);
        Some(PreviewFile::new(path, self.preview_every, Box::new(settings)))
    }

    /// Advice to ask for previews, for a picture that can have them and has none.
    pub(super) fn preview_advice(&self, scene: &Scene, target: Target) -> Option<String> {
        let has_samples = scene.image.samples > 1 && scene.image.adaptive.is_none();
        let is_still = self.frames.is_none() && target.band.is_none();
        let advised = has_samples && is_still && self.preview.is_none();
        advised.then(|| "help: --preview FILE.png shows the image while it is rendered".to_owned())
    }

    /// In the order of [`Layer::ALL`], each once; none without an EXR to hold them. How many samples a pixel took is a layer of
    /// adaptive pictures unless others ask for it.
    pub(super) fn layers(&self, scene: &Scene, before: Option<&Before>) -> Vec<Layer> {
        if !self.output.iter().chain(&self.preview).any(|path| is_exr(path)) {
            return Vec::new();
        }
        let usual = |layer: Layer| match layer {
            Layer::Shift => scene.has_frequencies(),
            Layer::Orders => scene.has_orders(),
            Layer::Samples => scene.image.adaptive.is_some(),
            Layer::Error => scene.rays.paths.is_some(),
            Layer::Sums | Layer::Spread => is_continuable(scene),
            _ => before.is_none_or(|before| before.layers().contains(&layer)),
        };
        let keeps =
            |layer: &Layer| self.layers.as_ref().map_or_else(|| usual(*layer), |wanted| wanted.contains(&Some(*layer)));
        Layer::ALL.into_iter().filter(keeps).collect()
    }

    /// Those that the program keeps: what a search compares too where the picture that gives the method was made after one, for
    /// another program may round otherwise.
    pub(super) fn kept(&self, layers: &[Layer], before: Option<&Before>) -> Vec<Layer> {
        let is_compared = before.map_or_else(|| self.changes.is_compared(), Before::is_compared);
        if is_compared { compared_layers(layers) } else { layers.to_owned() }
    }
}

/// How the file at `path` is to be written, which shows this window; `metadata` is what it says of itself.
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
        alpha: scene.is_transparent(),
        layers: if is_exr(path) { layers.to_vec() } else { Vec::new() },
        metadata: metadata.to_vec(),
    }
}
