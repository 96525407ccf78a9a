//! Shows the progress of long work as one line on `sys.stderr`, which notebooks and terminals redraw in place.

use std::time::{Duration, Instant};

use bentray::progress::Progress;
use pyo3::exceptions::PyException;
use pyo3::prelude::*;

/// Work that takes less time shows nothing.
const PATIENCE: Duration = Duration::from_secs(1);
/// The time between two lines.
const EVERY: Duration = Duration::from_millis(250);
/// The width of a line, which covers the one before.
const WIDTH: usize = 76;

/// A line of progress; it is removed when it is dropped.
pub struct Display {
    progress: &'static Progress,
    next: Instant,
    is_drawn: bool,
}

impl Display {
    pub fn new(progress: &'static Progress) -> Self {
        Self { progress, next: Instant::now() + PATIENCE, is_drawn: false }
    }

    /// Draws the current state, if it is time to. Writing runs Python, which may find a signal.
    pub fn draw(&mut self) -> PyResult<()> {
        if Instant::now() < self.next {
            return Ok(());
        }
        self.next = Instant::now() + EVERY;
        if let Some(state) = self.progress.state() {
            let done = state.done.map_or(String::new(), |done| format!(", {:.0} % done", 100.0 * done));
            self.is_drawn |= write(&format!("{}{done}", state.words))?;
        }
        Ok(())
    }
}

impl Drop for Display {
    fn drop(&mut self) {
        if self.is_drawn {
            // Nobody is left to tell.
            let _ = write("");
        }
    }
}

/// Writes a line in place, if somebody watches: in a terminal or a notebook. Returns `false` otherwise, and if the stream fails, because
/// progress is not worth an error; but an interrupt is one.
fn write(line: &str) -> PyResult<bool> {
    let line: String = line.chars().take(WIDTH).collect();
    Python::attach(|py| {
        let written = || {
            let sys = py.import("sys")?;
            let stream = sys.getattr("stderr")?;
            let is_notebook = sys.getattr("modules")?.contains("ipykernel")?;
            if !is_notebook && !stream.call_method0("isatty")?.extract::<bool>()? {
                return Ok(false);
            }
            let end = if line.is_empty() { "\r" } else { "" };
            stream.call_method1("write", (format!("\r{line:WIDTH$}{end}"),))?;
            stream.call_method0("flush")?;
            Ok(true)
        };
        written().or_else(|error: PyErr| if error.is_instance_of::<PyException>(py) { Ok(false) } else { Err(error) })
    })
}
