//! Films among the files that are asked for: each is made of the frames' own files in the end.
//!
//! *Practice.* Where no frames are asked for as PNGs, they go to a folder beside the first film, which is removed when all films are there. A
//! render that is stopped leaves it, and the same command goes on from it.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use super::Arguments;
use crate::cli::format::{Found, shown};
use crate::cli::frame_names::numbered;
use crate::cli::screen;
use crate::cli::share::Target;
use crate::error::Error;
use crate::output::{OutputError, alpha_in_film, check_film, film, has_extension, is_film};
use crate::scene::Scene;

/// A film that is finished.
struct Finished<'a> {
    path: &'a Path,
    frames: usize,
    /// Frames a second.
    rate: f64,
}

impl Found for Finished<'_> {
    fn text(&self) -> String {
        format!("{}: {} frames, {} a second", self.path.display(), self.frames, self.rate)
    }

    fn json(&self) -> Value {
        json!({ "film": shown(self.path), "frames": self.frames, "frames_per_second": self.rate })
    }
}

impl Arguments {
    /// Is this the name of a film, rather than of its frames?
    pub(super) fn is_film(&self, path: &Path) -> bool {
        self.frames.is_some() && is_film(path) && numbered(path, 0) == Ok(None)
    }

    fn films(&self) -> impl Iterator<Item = &PathBuf> {
        self.output.iter().filter(|path| self.is_film(path))
    }

    /// The folder of frames that are asked for only as a film.
    pub(super) fn frame_folder(&self) -> Option<PathBuf> {
        let has_own = self.output.iter().filter(|path| !self.is_film(path)).any(|path| has_extension(path, "png"));
        self.films().next().filter(|_| !has_own).map(|film| film.with_extension("frames"))
    }

    /// What is written of each frame: all that is asked for but films, and what those are made of.
    pub(super) fn pictures(&self) -> Vec<PathBuf> {
        let own = self.output.iter().filter(|path| !self.is_film(path)).cloned();
        own.chain(self.frame_folder().map(|folder| folder.join("{frame:5}.png"))).collect()
    }

    /// Refuses films that cannot be written, and makes the folder of frames.
    pub(in crate::cli) fn prepare_films(&self, scene: &Scene) -> Result<(), Error> {
        self.films().try_for_each(|path| check_film(path, self.window(scene).size))?;
        for path in self.films().filter(|_| scene.is_transparent()) {
            if let Some(words) = alpha_in_film(path) {
                tell!("warning: {} has no alpha: {words} (an animated .png keeps it)", path.display());
            }
        }
        let Some(folder) = self.frame_folder() else { return Ok(()) };
        let failed = |cause| OutputError::Create { path: folder.join("00000.png"), folder: folder.clone(), cause };
        Ok(fs::create_dir_all(&folder).map_err(failed)?)
    }

    /// Makes the films of these frames, which are all there.
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

    /// Removes the folder of frames that were asked for only as a film; those of another, longer film are left.
    pub(super) fn clear_frames(&self, targets: &[Target]) {
        let Some(folder) = self.frame_folder() else { return };
        let own = targets.iter().flat_map(|target| self.paths(*target)).filter(|path| path.starts_with(&folder));
        // What a render that was killed had under way.
        let lost = fs::read_dir(&folder).into_iter().flatten().filter_map(|entry| Some(entry.ok()?.path()));
        let lost = lost.filter(|path| path.extension().is_some_and(|extension| extension == "part"));
        for path in own.chain(lost) {
            // What cannot be removed does no harm.
            let _ = fs::remove_file(path);
        }
        let _ = fs::remove_dir(folder);
    }
}
