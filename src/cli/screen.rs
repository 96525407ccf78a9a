//! The display of progress: one line at the bottom of a terminal, redrawn in place, or an occasional line in a log.
//!
//! *Idea.* Work reports its progress to memory; a thread reads it ten times per second and draws. So a terminal shows that the program
//! is alive even while one unit of work takes long, and a log gets its lines on time.
//!
//! *Practice.* All messages of the program go through [`cleared`], so that they appear above the line and never inside it. Work that
//! ends before [`PATIENCE`] draws nothing. The line has no color, and lines of a log have no control characters.

mod drawn;

use std::io::{self, IsTerminal, Write};
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::sync::{LazyLock, Mutex, MutexGuard, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use indicatif::ProgressDrawTarget;

use crate::progress::Progress;
use drawn::Screen;

/// The time between two readings of the progress.
const TICK: Duration = Duration::from_millis(100);
/// Work that takes less time draws no line on the terminal.
const PATIENCE: Duration = Duration::from_millis(700);
/// The time between two lines of a log.
const EVERY: Duration = Duration::from_secs(30);

/// The progress of the process, which is one because the process has one terminal.
static PROGRESS: LazyLock<Progress> = LazyLock::new(Progress::watched);
/// The current display; `None` before [`Drawing::begin`] and after its end.
static SCREEN: Mutex<Option<Screen>> = Mutex::new(None);

/// Returns the progress that is displayed.
pub(super) fn progress() -> Progress {
    PROGRESS.clone()
}

/// Sets advice that is printed once, if the current work turns out to take long; `None` withdraws it.
pub(super) fn advise(advice: Option<String>) {
    if let Some(screen) = &mut *screen() {
        screen.advise(advice);
    }
}

/// Removes the line from the terminal, and keeps it away while the guard is held: for a message, or the end of the process.
pub(super) fn cleared() -> MutexGuard<'static, Option<Screen>> {
    let mut screen = screen();
    if let Some(screen) = &mut *screen {
        screen.clear();
    }
    screen
}

fn screen() -> MutexGuard<'static, Option<Screen>> {
    // A line that was drawn halfway is redrawn.
    SCREEN.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The display of progress, until it is dropped; then the terminal is restored.
pub(super) struct Drawing {
    end: Option<Sender<()>>,
    thread: Option<JoinHandle<()>>,
}

impl Drawing {
    /// Starts to draw to standard error.
    pub(super) fn begin() -> Self {
        let term = std::env::var("TERM").ok();
        let is_redrawn = io::stderr().is_terminal() && redraws(term.as_deref());
        let new = if is_redrawn { Screen::terminal(ProgressDrawTarget::stderr, PATIENCE) } else { Screen::log(EVERY) };
        *screen() = Some(new);
        let (end, ended) = channel();
        let begun = Instant::now();
        let draw = move || {
            while let Err(RecvTimeoutError::Timeout) = ended.recv_timeout(TICK) {
                if let Some(screen) = &mut *screen() {
                    screen.look(begun.elapsed(), PROGRESS.state().as_ref(), &mut io::stderr());
                }
            }
        };
        // If no thread can be started, the work runs without progress.
        let thread = thread::Builder::new().name("progress".to_owned()).spawn(draw).ok();
        Self { end: Some(end), thread }
    }
}

impl Drop for Drawing {
    fn drop(&mut self) {
        drop(self.end.take());
        // The thread ends by itself, and its line is cleared below.
        let _ = self.thread.take().map(JoinHandle::join);
        if let Some(mut screen) = screen().take() {
            screen.clear();
        }
    }
}

/// Returns `true` if a terminal of this name can redraw a line. On Windows, terminals have no name.
fn redraws(term: Option<&str>) -> bool {
    term.map_or(cfg!(windows), |name| !["", "dumb"].contains(&name))
}

/// Prints a line of messages above the progress line.
pub(super) fn print_above(to: &mut dyn Write, line: std::fmt::Arguments) -> io::Result<()> {
    let _held = cleared();
    writeln!(to, "{line}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dumb_terminals_are_logs() {
        assert!(redraws(Some("xterm-256color")) && redraws(Some("linux")));
        assert!(!redraws(Some("dumb")) && !redraws(Some("")));
        assert_eq!(redraws(None), cfg!(windows));
    }
}
