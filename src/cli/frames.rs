//! Frames of an animation: their scenes, and a check that one program runs them all.

use std::cell::RefCell;
use std::collections::HashMap;
use std::hash::{Hash, Hasher};
use std::path::{Path, PathBuf};

use super::screen;
use crate::document::read_given;
use crate::error::Error;
use crate::gpu::{Geometry, PreviousGeometry, mesh_capacity};
use crate::program::{Program, ProgramOptions};
use crate::scene::{Animation, Files, Override, Scene, SceneError, follow_as};

/// Calls `made` with a function that returns the frame number for every key, or with `None` without a frame.
pub(super) fn with_frame<T>(frame: Option<u32>, made: impl FnOnce(Option<&dyn Fn(&str) -> f64>) -> T) -> T {
    match frame {
        Some(frame) => made(Some(&|_| frame.into())),
        None => made(None),
    }
}

fn of_frame(frame: f64, error: Error) -> Error {
    Error::Frame { frame, error: Box::new(error) }
}

/// A scene file whose frames are loaded one after the other.
pub(super) struct Film<'a> {
    pub(super) path: &'a Path,
    pub(super) overrides: Vec<Override>,
    pub(super) files: RefCell<Files>,
    /// The hashes of the files, by path.
    pub(super) hashes: RefCell<HashMap<PathBuf, String>>,
    /// The inputs of the previous frame's program.
    before: RefCell<PreviousGeometry>,
}

impl<'a> Film<'a> {
    pub(super) fn new(path: &'a Path, overrides: Vec<Override>) -> Self {
        let files = Files::default().reporting(screen::progress()).into();
        Self { path, overrides, files, hashes: RefCell::default(), before: RefCell::default() }
    }

    /// Rejects meshes that exceed the memory of the best device, or of the first whose name contains `device`, when their size is known.
    pub(super) fn on(self, device: Option<&str>) -> Self {
        Self { files: self.files.into_inner().holding(mesh_capacity(device)).into(), ..self }
    }

    /// Limits the memory of the loaded files, in bytes.
    pub(super) fn within(self, memory: u64) -> Self {
        Self { files: self.files.into_inner().within(memory).into(), ..self }
    }

    /// Loads the scene, or one of its frames: `frame_of` is the argument of [`Scene::load_with`].
    pub(super) fn load(&self, frame_of: Option<&dyn Fn(&str) -> f64>) -> Result<Scene, SceneError> {
        Scene::load_with(&mut self.files.borrow_mut(), self.path, &self.overrides, frame_of)
    }

    /// Loads the scene like [`load`](Self::load), with the method in a text of [`Rays::followed`](crate::scene::Rays::followed).
    pub(super) fn load_as(&self, frame: Option<u32>, followed: &str) -> Result<Scene, SceneError> {
        let overrides: Vec<Override> = self.overrides.iter().cloned().chain(follow_as(followed)?).collect();
        with_frame(frame, |frame_of| Scene::load_with(&mut self.files.borrow_mut(), self.path, &overrides, frame_of))
    }

    /// Hashes the inputs of the scene: its file, the overrides, and the files that were loaded for it. Returns `None` if one of them no
    /// longer exists.
    pub(super) fn hash(&self, hasher: &mut impl Hasher) -> Option<()> {
        read_given(self.path).ok()?.hash(hasher);
        for over in &self.overrides {
            over.text().hash(hasher);
        }
        for path in self.files.borrow().paths() {
            path.hash(hasher);
            self.hash_of(path).ok()?.hash(hasher);
        }
        Some(())
    }

    /// Returns the scene's file and the files loaded for it, each with a description.
    pub(super) fn inputs(&self) -> Vec<(PathBuf, &'static str)> {
        let own = self.files.borrow().paths().into_iter().map(|path| (path, "a file that the scene reads"));
        std::iter::once((self.path.to_owned(), "the scene file")).chain(own).collect()
    }

    /// Builds the program of a frame, or reuses that of the previous frame.
    fn program(
        &self,
        before: Option<&Program>,
        options: &ProgramOptions,
        frame_of: &dyn Fn(&str) -> f64,
    ) -> Result<Program, Error> {
        let scene = self.load(Some(frame_of))?;
        let geometry = Geometry::after(self.before.take(), &scene);
        let program = Program::after(before, &scene, &geometry.analysis, options, geometry.extent());
        self.before.replace(geometry.into_before());
        Ok(program?)
    }

    /// Checks frames before any is rendered: that they are valid, and run the first frame's program. For a long animation it checks only
    /// evenly spaced frames and the last, at most `most`. Returns the number of frames that were checked.
    pub(super) fn look_ahead(
        &self,
        options: &ProgramOptions,
        animation: &Animation,
        frames: &[u32],
        most: usize,
    ) -> Result<u32, Error> {
        let Some((&first, last)) = frames.first().zip(frames.len().checked_sub(1)) else { return Ok(0) };
        let program = self.program(None, options, &|_| first.into())?;
        let looked_at = frames.len().min(most);
        for i in 0..looked_at {
            let frame = f64::from(frames[i * last / (looked_at - 1).max(1)]);
            let closes = (animation.shutter > 0.0).then_some(frame + animation.shutter);
            for time in (i > 0).then_some(frame).into_iter().chain(closes) {
                let own = self.program(Some(&program), options, &|_| time).map_err(|error| of_frame(time, error))?;
                if !own.runs_as(&program) {
                    return Err(self.other_program(&animation.keys, [first.into(), time]));
                }
            }
        }
        Ok(looked_at as u32)
    }

    /// Loads the scenes of a frame's shutter samples, in order; the frame's scene gives their number.
    pub(super) fn moments(&self, frame: u32, scene: &Scene) -> Result<Vec<Scene>, Error> {
        let load = |time| self.load(Some(&|_| time)).map_err(|error| of_frame(time, error.into()));
        scene.moments(frame).into_iter().map(load).collect()
    }

    /// Creates the error that two frames need different programs. It names the keys that alone cause this when they change from the first
    /// frame to the other.
    pub(super) fn other_program(&self, keys: &[String], [first, frame]: [f64; 2]) -> Error {
        let options = ProgramOptions::default();
        let moved = |moved: Option<&str>| {
            self.program(None, &options, &|key| if moved == Some(key) { frame } else { first }).ok()
        };
        let before = moved(None);
        let changes = |key: &&String| match (&before, moved(Some(key))) {
            (Some(before), Some(after)) => !after.runs_as(before),
            _ => true,
        };
        let named: Vec<String> = keys.iter().filter(changes).map(|key| format!("`{key}`")).collect();
        let cause = if named.is_empty() { "several keys in combination".to_owned() } else { named.join(", ") };
        usage!(
            "frame {frame} requires a different shader program than frame {first} because of {cause}: avoid this \
             change, or render the frames from {frame} on with a separate command"
        )
    }
}
