//! The requested videos: each is encoded from the files of its frames at the end.
//!
//! *Practice.* If no frames are requested as PNGs, they go to a folder next to the first video, which is removed when all videos are
//! complete. A render that is stopped keeps the folder, and the same command continues from it.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use super::Arguments;
use crate::cli::format::{CommandResult, shown};
use crate::cli::frame_names::numbered;
use crate::cli::screen;
use crate::cli::share::Target;
use crate::error::Error;
use crate::output::{OutputError, alpha_in_film, check_film, film, has_extension, is_film};
use crate::scene::Scene;

/// A video that is finished.
struct Finished<'a> {
    path: &'a Path,
    frames: usize,
    /// The frame rate, in frames per second.
    rate: f64,
}

impl CommandResult for Finished<'_> {
    fn text(&self) -> String {
        format!("{}: {} frames, {} per second", self.path.display(), self.frames, self.rate)
    }

    fn json(&self) -> Value {
        json!({ "video": shown(self.path), "frames": self.frames, "frames_per_second": self.rate })
    }
}

impl Arguments {
    /// Returns `true` if a path is the name of a video, and not of its frames.
    pub(super) fn is_film(&self, path: &Path) -> bool {
        self.frames.is_some() && is_film(path) && numbered(path, 0) == Ok(None)
    }

    fn films(&self) -> impl Iterator<Item = &PathBuf> {
        self.output.iter().filter(|path| self.is_film(path))
    }

    /// Returns the folder for frames that are requested only as a video.
    pub(super) fn frame_folder(&self) -> Option<PathBuf> {
        let has_own = self.output.iter().filter(|path| !self.is_film(path)).any(|path| has_extension(path, "png"));
        self.films().next().filter(|_| !has_own).map(|film| film.with_extension("frames"))
    }

    /// Returns the files of each frame: all requested files except videos, and the images for the videos.
    pub(super) fn pictures(&self) -> Vec<PathBuf> {
        let own = self.output.iter().filter(|path| !self.is_film(path)).cloned();
        own.chain(self.frame_folder().map(|folder| folder.join("{frame:5}.png"))).collect()
    }

    /// Rejects videos that cannot be written, and creates the folder of frames.
    pub(in crate::cli) fn prepare_films(&self, scene: &Scene) -> Result<(), Error> {
        self.films().try_for_each(|path| check_film(path, self.window(scene).size))?;
        for path in self.films().filter(|_| scene.is_transparent()) {
            if let Some(words) = alpha_in_film(path) {
                tell!(
                    "warning: {} cannot store all alpha values: {words} (an animated .png keeps alpha)",
                    path.display()
                );
            }
        }
        let Some(folder) = self.frame_folder() else { return Ok(()) };
        let failed = |cause| OutputError::Create { path: folder.join("00000.png"), folder: folder.clone(), cause };
        Ok(fs::create_dir_all(&folder).map_err(failed)?)
    }

    /// Encodes the videos of these frames, which all exist.
    pub(in crate::cli) fn make_films(&self, targets: &[Target], rate: f64) -> Result<(), Error> {
        let pictures = self.pictures();
        let Some(png) = pictures.iter().find(|path| has_extension(path, "png")) else { return Ok(()) };
        let frames: Vec<PathBuf> = targets.iter().map(|target| target.path(png)).collect();
        for path in self.films() {
            film(path, &frames, rate, &screen::progress())?;
            self.format.tell(&Finished { path, frames: frames.len(), rate })?;
        }
        Ok(())
    }

    /// Removes the folder of frames that were requested only as a video; frames of another, longer video are kept.
    pub(super) fn clear_frames(&self, targets: &[Target]) {
        let Some(folder) = self.frame_folder() else { return };
        let own = targets.iter().flat_map(|target| self.paths(*target)).filter(|path| path.starts_with(&folder));
        // Unfinished files of a render that was killed.
        let lost = fs::read_dir(&folder).into_iter().flatten().filter_map(|entry| Some(entry.ok()?.path()));
        let lost = lost.filter(|path| path.extension().is_some_and(|extension| extension == "part"));
        for path in own.chain(lost) {
            // A file that cannot be removed does no harm.
            let _ = fs::remove_file(path);
        }
        let _ = fs::remove_dir(folder);
    }
}
