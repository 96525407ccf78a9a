//! Signals that ask the process to end: Ctrl-C, a closed terminal, or a queue whose time limit is near.
//!
//! *Practice.* Unfinished files are removed, so that earlier files remain; a line names the signal and reports the files on disk; and the
//! process ends with 128 plus the signal's number. An animation first finishes the current frame, and ends at once at a second signal.
//! A signal that was ignored when the process started, as with `nohup`, stays ignored.

use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::atomic::{AtomicI32, AtomicUsize, Ordering};

use signal_hook::low_level::{exit, signal_name};

use crate::output::abandon_unfinished;

/// The signal that was received; 0 for none.
static ASKED: AtomicI32 = AtomicI32::new(0);
/// The number of frames of the animation; the next value counts those on disk.
static FRAMES: AtomicUsize = AtomicUsize::new(0);
static DONE: AtomicUsize = AtomicUsize::new(0);

/// Handles signals from now on.
pub(super) fn listen() {
    // If no signals can be handled, the process ends in the system's default way.
    let _ = system::listen();
}

/// Ends the process, unless there is a frame to finish first.
fn ask(signal: i32) {
    let first = ASKED.swap(signal, Ordering::SeqCst) == 0;
    if first && FRAMES.load(Ordering::SeqCst) > 0 {
        tell!("{}: stopping after this frame; send it again to stop immediately", name(signal));
        return;
    }
    // The lock keeps others from starting a file before the process is gone. The process exits at once: other cleanup would take the driver
    // away from the render that is still running, which crashes some drivers.
    let (unfinished, _held) = abandon_unfinished();
    tell!("{}", words(signal, &unfinished));
    exit(code(signal));
}

/// Registers a sequence of frames: the current one is finished before the process ends.
pub(super) fn finish_first(frames: usize) {
    FRAMES.store(frames, Ordering::SeqCst);
}

/// Records the number of frames on disk.
pub(super) fn done(frames: usize) {
    DONE.store(frames, Ordering::SeqCst);
}

/// Returns `true` if the process was asked to end.
pub(super) fn is_asked() -> bool {
    ASKED.load(Ordering::SeqCst) != 0
}

/// Prints why an animation ends early, if the process was asked to end, and returns its exit code.
pub(super) fn stopped() -> Option<ExitCode> {
    let signal = ASKED.load(Ordering::SeqCst);
    (signal != 0).then(|| {
        tell!("{}", words(signal, &[]));
        ExitCode::from(code(signal) as u8)
    })
}

/// Returns the exit code that shells report for a process that ended by a signal.
fn code(signal: i32) -> i32 {
    128 + signal
}

fn name(signal: i32) -> String {
    signal_name(signal).map_or_else(|| format!("signal {signal}"), str::to_owned)
}

/// Returns the message with the signal that ended the process, and the files on disk.
fn words(signal: i32, unfinished: &[PathBuf]) -> String {
    let frames = FRAMES.load(Ordering::SeqCst);
    let mut parts = vec![format!("stopped by {}", name(signal))];
    if !unfinished.is_empty() {
        let names: Vec<_> = unfinished.iter().map(|path| path.display().to_string()).collect();
        let is_one = names.len() == 1;
        let (verb, earlier) =
            if is_one { ("was", "an earlier file with this name") } else { ("were", "earlier files with these names") };
        let kept = if is_one { "is" } else { "are" };
        parts.push(format!("{} {verb} not finished; {earlier} {kept} unchanged", names.join(", ")));
    } else if frames == 0 {
        parts.push("no file was being written".to_owned());
    }
    if frames > 0 {
        let done = DONE.load(Ordering::SeqCst);
        parts.push(format!("{done} of {frames} frames are on disk; run the command again to continue"));
    }
    parts.join("; ")
}

#[cfg(unix)]
mod system {
    use std::io;
    use std::process::{Command, Stdio};
    use std::thread;

    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM, SIGUSR1, SIGUSR2};
    use signal_hook::iterator::Signals;

    /// The signals of terminals and of job queues before their time limit, with their names for `kill`.
    const ENDING: [(i32, &str); 5] =
        [(SIGHUP, "HUP"), (SIGINT, "INT"), (SIGTERM, "TERM"), (SIGUSR1, "USR1"), (SIGUSR2, "USR2")];

    pub(super) fn listen() -> io::Result<()> {
        let ignored = ignored_by_system().unwrap_or_else(ignored_by_child);
        let heard = ENDING.iter().map(|(signal, _)| *signal).filter(|signal| !ignored.contains(signal));
        let mut signals = Signals::new(heard)?;
        thread::Builder::new().name("signals".to_owned()).spawn(move || signals.forever().for_each(super::ask))?;
        Ok(())
    }

    /// Returns the signals that the process ignores, as reported by Linux.
    fn ignored_by_system() -> Option<Vec<i32>> {
        let status = std::fs::read_to_string("/proc/self/status").ok()?;
        let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"))?;
        let mask = u64::from_str_radix(mask.trim(), 16).ok()?;
        Some((1..=64).filter(|signal| mask >> (signal - 1) & 1 == 1).collect())
    }

    /// Returns the ignored signals on other systems: a child ignores those of its parent, and survives them. Without `unsafe` code, the
    /// process cannot query a signal.
    fn ignored_by_child() -> Vec<i32> {
        let outlives = |name: &str| {
            let mut shell = Command::new("sh");
            shell
                .args(["-c", &format!("kill -{name} $$")])
                .stdin(Stdio::null())
                .stdout(Stdio::null())
                .stderr(Stdio::null());
            shell.status().is_ok_and(|status| status.success())
        };
        ENDING.iter().filter(|(_, name)| outlives(name)).map(|(signal, _)| *signal).collect()
    }

    #[cfg(test)]
    mod tests {
        use super::*;

        #[test]
        fn a_child_knows_what_the_system_says() {
            let Some(ignored) = ignored_by_system() else { return };
            let asked: Vec<i32> = ENDING.iter().map(|(signal, _)| *signal).filter(|s| ignored.contains(s)).collect();
            assert_eq!(ignored_by_child(), asked);
        }
    }
}

#[cfg(windows)]
mod system {
    use signal_hook::consts::SIGINT;

    pub(super) fn listen() -> Result<(), ctrlc::Error> {
        ctrlc::set_handler(|| super::ask(SIGINT))
    }
}
