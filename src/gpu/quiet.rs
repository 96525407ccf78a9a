//! Keeps a driver's layer from reporting an error where there is none.
//!
//! *Practice.* A layer of Mesa's, which puts the desktop's GPU first, looks for a Wayland display whenever devices are listed. On a server
//! without a desktop libwayland then writes a line that begins with `error:` to standard error, though nothing is wrong; only environment
//! variables turn that off. So standard error is led through a pipe while devices are listed, and every other line is passed on as it
//! comes. Where there is a desktop, nothing of this happens.

/// Runs `list`, which lists devices, without libwayland's line.
#[cfg(not(all(unix, not(target_vendor = "apple"))))]
pub(super) fn quietly<T>(list: impl FnOnce() -> T) -> T {
    list()
}

/// Runs `list`, which lists devices, without libwayland's line.
#[cfg(all(unix, not(target_vendor = "apple")))]
pub(super) fn quietly<T>(list: impl FnOnce() -> T) -> T {
    // Without a pipe the line is printed, which does no harm.
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

    /// What the line begins with.
    const LINE: &[u8] = b"error: XDG_RUNTIME_DIR is invalid or not set";
    /// Ends what was written while devices were listed.
    const END: &[u8] = b"\0end\n";

    /// Standard error is one for the whole process.
    static ONE: Mutex<()> = Mutex::new(());

    /// Will libwayland find no folder for its sockets? It looks for these variables itself.
    pub(super) fn is_expected() -> bool {
        let is_absolute = |name| env::var_os(name).is_some_and(|value| Path::new(&value).is_absolute());
        env::var_os("NODEVICE_SELECT").is_none() && !["XDG_RUNTIME_DIR", "WAYLAND_DISPLAY"].into_iter().any(is_absolute)
    }

    /// Standard error without that line, until it is dropped.
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
            // Whoever waits for the end is there until then.
            let ended_there = move || end.send(()).unwrap_or_default();
            let forward = move || forward(BufReader::new(reader), onward, ended_there);
            thread::Builder::new().name("stderr".to_owned()).spawn(forward)?;
            dup2_stderr(&pipe)?;
            Ok(Self { kept, pipe, ended, _one: one })
        }
    }

    impl Drop for Filter {
        fn drop(&mut self) {
            // A child that was started meanwhile may hold the pipe for long, so its end is not waited for.
            if dup2_stderr(&self.kept).is_ok() && self.pipe.write_all(END).is_ok() {
                let _ = self.ended.recv();
            }
        }
    }

    /// Passes on what is written to standard error, line by line; `ended` is called behind the mark that ends it.
    fn forward(mut from: impl BufRead, mut onward: impl Write, ended: impl Fn()) {
        let mut line = Vec::new();
        while from.read_until(b'\n', &mut line).is_ok_and(|length| length > 0) {
            let text = line.strip_suffix(END);
            let own = text.unwrap_or(&line);
            if !own.starts_with(LINE) {
                // There is no other place to report this.
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
