//! Suppresses a false error message of a driver layer.
//!
//! *Practice.* A layer of Mesa, which puts the desktop's GPU first, looks for a Wayland display whenever devices are listed. On a server
//! without a desktop, libwayland then writes a line that begins with `error:` to standard error, although nothing is wrong; only
//! environment variables turn this off. Therefore standard error passes through a pipe while devices are listed, and every other line is
//! forwarded at once. If there is a desktop, this module does nothing.

/// Runs `list`, which lists devices, without libwayland's line.
#[cfg(not(all(unix, not(target_vendor = "apple"))))]
pub(super) fn quietly<T>(list: impl FnOnce() -> T) -> T {
    list()
}

/// Runs `list`, which lists devices, without libwayland's line.
#[cfg(all(unix, not(target_vendor = "apple")))]
pub(super) fn quietly<T>(list: impl FnOnce() -> T) -> T {
    // Without a pipe the line is printed, which is harmless.
    let _filter = unix::is_expected().then(unix::Filter::begin).and_then(Result::ok);
    list()
}

#[cfg(all(unix, not(target_vendor = "apple")))]
mod unix {
    use std::env;
    use std::fs::File;
    use std::io::{self, BufRead, BufReader, PipeWriter, Write};
    use std::os::fd::{AsFd, OwnedFd};
    use std::path::Path;
    use std::sync::mpsc::{Receiver, channel};
    use std::sync::{Mutex, MutexGuard, PoisonError};
    use std::thread;

    use rustix::stdio::dup2_stderr;

    /// The beginning of the suppressed line.
    const LINE: &[u8] = b"error: XDG_RUNTIME_DIR is invalid or not set";
    /// The mark that ends the output written while devices are listed.
    const END: &[u8] = b"\0end\n";

    /// A lock, because the process has only one standard error.
    static ONE: Mutex<()> = Mutex::new(());

    /// Returns `true` if libwayland will not find a folder for its sockets; it reads these variables itself.
    pub(super) fn is_expected() -> bool {
        let is_absolute = |name| env::var_os(name).is_some_and(|value| Path::new(&value).is_absolute());
        env::var_os("NODEVICE_SELECT").is_none() && !["XDG_RUNTIME_DIR", "WAYLAND_DISPLAY"].into_iter().any(is_absolute)
    }

    /// A filter that removes the line from standard error until it is dropped.
    pub(super) struct Filter {
        kept: OwnedFd,
        pipe: PipeWriter,
        ended: Receiver<()>,
        _one: MutexGuard<'static, ()>,
    }

    impl Filter {
        pub(super) fn begin() -> io::Result<Self> {
            let one = ONE.lock().unwrap_or_else(PoisonError::into_inner);
            let kept = io::stderr().as_fd().try_clone_to_owned()?;
            let onward = File::from(kept.try_clone()?);
            let (reader, pipe) = io::pipe()?;
            let (end, ended) = channel();
            // The receiver exists until the end is reported.
            let ended_there = move || end.send(()).unwrap_or_default();
            let forward = move || forward(BufReader::new(reader), onward, ended_there);
            thread::Builder::new().name("stderr".to_owned()).spawn(forward)?;
            dup2_stderr(&pipe)?;
            Ok(Self { kept, pipe, ended, _one: one })
        }
    }

    impl Drop for Filter {
        fn drop(&mut self) {
            // Do not wait for the pipe to close: a child process that started meanwhile may hold it for long.
            if dup2_stderr(&self.kept).is_ok() && self.pipe.write_all(END).is_ok() {
                let _ = self.ended.recv();
            }
        }
    }

    /// Forwards the text written to standard error line by line, and calls `ended` after the end mark.
    fn forward(mut from: impl BufRead, mut onward: impl Write, ended: impl Fn()) {
        let mut line = Vec::new();
        while from.read_until(b'\n', &mut line).is_ok_and(|length| length > 0) {
            let text = line.strip_suffix(END);
            let own = text.unwrap_or(&line);
            if !own.starts_with(LINE) {
                // A failure cannot be reported anywhere else.
                let _ = onward.write_all(own);
            }
            if text.is_some() {
                ended();
            }
            line.clear();
        }
    }

    #[cfg(test)]
    mod tests {
        use std::cell::Cell;

        use super::*;

        #[test]
        fn all_but_one_line_is_passed_on() {
            let line = "error: XDG_RUNTIME_DIR is invalid or not set in the environment.\n";
            for (written, passed) in [
                (format!("a\n{line}error: of a driver\n{line}"), "a\nerror: of a driver\n"),
                (format!("{line}half a line"), "half a line"),
                (String::new(), ""),
                ("error: XDG_RUNTIME_DIR of another kind\n".to_owned(), "error: XDG_RUNTIME_DIR of another kind\n"),
            ] {
                let (mut onward, ends) = (Vec::new(), Cell::new(0));
                let all = [written.as_bytes(), END, b"later\n"].concat();
                forward(all.as_slice(), &mut onward, || ends.set(ends.get() + 1));
                assert_eq!((String::from_utf8(onward).unwrap(), ends.get()), (format!("{passed}later\n"), 1));
            }
        }
    }
}
