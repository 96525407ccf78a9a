//! The files of a render: what each holds, and what it says of itself.

use std::path::{Path, PathBuf};

use super::{Arguments, is_exr};
use crate::cli::frames::{Film, path_of};
use crate::cli::go_on::{self, Before, is_continuable};
use crate::cli::paths;
use crate::cli::watch::PreviewFile;
use crate::error::Error;
use crate::output::origin::file_difference;
use crate::output::{FileSettings, ImageWriter, open, settings_of};
use crate::program::Layer;
use crate::render::Window;
use crate::scene::Scene;

impl Arguments {
    /// Begins the files of a frame.
    pub(super) fn open(
        &self,
        scene: &Scene,
        frame: Option<u32>,
        layers: &[Layer],
        metadata: &[(String, String)],
    ) -> Result<Vec<Box<dyn ImageWriter>>, Error> {
        let path = |path: &PathBuf| frame.and_then(|frame| path_of(path, frame)).unwrap_or(path.clone());
        let paths = self.output.iter().map(path);
        paths.map(|path| Ok(open(&path, &self.file_settings(scene, &path, layers, metadata))?)).collect()
    }

    /// Are a frame's files there, made by what would make them now? Files of something else are named.
    pub(super) fn is_finished(
        &self,
        scene: &Scene,
        frame: u32,
        layers: &[Layer],
        metadata: &[(String, String)],
    ) -> bool {
        self.output.iter().all(|path| {
            let path = path_of(path, frame).unwrap_or_else(|| path.clone());
            if !path.exists() {
                return false;
            }
            let wanted = self.file_settings(scene, &path, layers, metadata);
            let why = match settings_of(&path) {
                Ok(found) => file_difference(&found, &wanted),
                Err(_) => Some("it is no picture of this version of bentray".to_owned()),
            };
            if let Some(why) = &why {
                tell!("frame {frame}: {} is rendered again: {why}", path.display());
            }
            why.is_none()
        })
    }

    /// Refuses to write over the scene's own files, or two things to one file.
    pub(super) fn check_files(&self, film: &Film, frames: &[Option<u32>]) -> Result<(), Error> {
        let of_frame = |frame: &Option<u32>| {
            let frame = *frame;
            self.output.iter().map(move |path| frame.and_then(|frame| path_of(path, frame)).unwrap_or(path.clone()))
        };
        let outputs: Vec<PathBuf> = frames.iter().flat_map(of_frame).chain(self.preview.clone()).collect();
        paths::check(outputs.iter().map(PathBuf::as_path), &film.inputs())
    }

    /// Opens all files and drops them again: a path that cannot be written is found before the work.
    pub(super) fn try_files(&self, still: &Scene, frames: &[Option<u32>], layers: &[Layer]) -> Result<(), Error> {
        for &frame in frames {
            drop(self.open(still, frame, layers, &[])?);
        }
        let Some(path) = &self.preview else { return Ok(()) };
        if still.image.adaptive.is_some() {
            let problem = "--preview: an adaptive picture has none, for its pixels do not take their samples together";
            return Err(Error::Usage(problem.to_owned()));
        }
        drop(open(path, &self.file_settings(still, path, layers, &[]))?);
        Ok(())
    }

    /// How the file at `path` is to be written; `metadata` is what it says of itself.
    pub(super) fn file_settings(
        &self,
        scene: &Scene,
        path: &Path,
        layers: &[Layer],
        metadata: &[(String, String)],
    ) -> FileSettings {
        FileSettings {
            size: scene.image.size,
            window: self.crop.unwrap_or(Window::whole(scene.image.size)),
            exposure: scene.output.exposure,
            tonemap: scene.output.tonemap,
            bits: scene.output.bits,
            alpha: scene.is_transparent(),
            layers: if is_exr(path) { layers.to_vec() } else { Vec::new() },
            metadata: metadata.to_vec(),
        }
    }

    /// The file that shows the picture while it is rendered.
    pub(super) fn preview(
        &self,
        scene: &Scene,
        layers: &[Layer],
        metadata: &[(String, String)],
    ) -> Option<PreviewFile> {
        let path = self.preview.clone()?;
        let settings = self.file_settings(scene, &path, layers, metadata);
        let settings = move |samples| go_on::after(settings.clone(), samples);
        Some(PreviewFile::new(path, self.preview_every, Box::new(settings)))
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
}
