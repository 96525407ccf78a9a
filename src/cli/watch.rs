//! A render while it is under way: how far it is, and what it has come to so far.

use std::cell::Cell;
use std::io::IsTerminal;
use std::path::PathBuf;
use std::time::{Duration, Instant};

use indicatif::{HumanDuration, ProgressBar, ProgressStyle};

use crate::output::{FileSettings, OutputError, open};
use crate::render::{Band, Preview, RenderError};

/// Between two lines that say how far a render is, where no bar does.
const QUIET: Duration = Duration::from_secs(30);

/// How far a render is: a bar on a terminal, a line now and then elsewhere.
pub(super) struct Progress {
    bar: ProgressBar,
    begun: Instant,
    said: Cell<Instant>,
}

impl Progress {
    pub(super) fn new() -> Self {
        let bar = ProgressBar::new(1000);
        if let Ok(style) = ProgressStyle::with_template("{bar:40} {percent:>3} %  {eta} left") {
            bar.set_style(style);
        }
        Self { bar, begun: Instant::now(), said: Cell::new(Instant::now()) }
    }

    /// The part that is done.
    pub(super) fn tell(&self, done: f64) {
        self.bar.set_position((done * 1000.0) as u64);
        if !std::io::stderr().is_terminal() && self.said.get().elapsed() >= QUIET {
            self.said.set(Instant::now());
            tell!("{}", line(done, self.begun.elapsed()));
        }
    }

    pub(super) fn finish(&self) {
        self.bar.finish_and_clear();
    }
}

/// How far a film is: a line now and then.
pub(super) struct FilmProgress {
    frames: usize,
    begun: Instant,
    said: Cell<Instant>,
}

impl FilmProgress {
    pub(super) fn new(frames: usize) -> Self {
        Self { frames, begun: Instant::now(), said: Cell::new(Instant::now()) }
    }

    /// So many frames are done.
    pub(super) fn tell(&self, done: usize) {
        if done < self.frames && self.said.get().elapsed() >= QUIET {
            self.said.set(Instant::now());
            let part = done as f64 / self.frames as f64;
            tell!("{done} of {} frames: {}", self.frames, line(part, self.begun.elapsed()));
        }
    }
}

/// How far a render is that has taken so long.
fn line(done: f64, taken: Duration) -> String {
    let left = Duration::try_from_secs_f64(taken.as_secs_f64() * (1.0 - done) / done);
    let left = left.map_or_else(|_| "a long time".to_owned(), |left| HumanDuration(left).to_string());
    format!("{:.0} % done, about {left} left", 100.0 * done)
}

/// A file that shows the picture so far, written anew now and then, whole each time.
pub(super) struct PreviewFile {
    path: PathBuf,
    every: Duration,
    /// How it is written after so many samples.
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
        let write = || -> Result<(), OutputError> {
            let mut writer = open(&self.path, &(self.settings)(samples))?;
            writer.write_band(picture)?;
            writer.finish()
        };
        write().map_err(|error| RenderError::Output(Box::new(error)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_say_the_time_left() {
        assert_eq!(line(0.25, Duration::from_secs(60)), "25 % done, about 3 minutes left");
        assert_eq!(line(0.0, Duration::from_secs(60)), "0 % done, about a long time left");
    }
}
