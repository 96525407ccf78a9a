//! Previews of an image, written during the render.

use std::path::PathBuf;
use std::time::Duration;

use super::screen;
use crate::output::{FileSettings, OutputError, open};
use crate::render::{Band, Preview, RenderError};

/// A file with the unfinished image, rewritten at intervals, complete each time.
pub(super) struct PreviewFile {
    path: PathBuf,
    every: Duration,
    /// Returns the file settings after a number of samples.
    settings: Box<dyn Fn(u32) -> FileSettings>,
}

impl PreviewFile {
    pub(super) fn new(path: PathBuf, every: Duration, settings: Box<dyn Fn(u32) -> FileSettings>) -> Self {
        Self { path, every, settings }
    }
}

impl Preview for PreviewFile {
    fn every(&self) -> Duration {
        self.every
    }

    fn look(&self, picture: &Band, samples: u32) -> Result<(), RenderError> {
        let _stage = screen::progress().stage(format!("writing {}", self.path.display()));
        let write = || -> Result<(), OutputError> {
            let mut writer = open(&self.path, &(self.settings)(samples))?;
            writer.write_band(picture)?;
            writer.finish()
        };
        write().map_err(|error| RenderError::Output(Box::new(error)))
    }
}
