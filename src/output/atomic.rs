//! Files that are written completely or not at all.
//!
//! The bytes go to a temporary file in the target's folder, which is renamed to the target when it is finished: readers see the old file or
//! the new one, never a part. If the writer is dropped before that, the temporary file is removed and the target is unchanged. An
//! interrupted process removes unfinished files by [`abandon_unfinished`]; a killed one may leave the temporary file, whose name begins
//! with a dot and ends in `.part`. The cost is a buffer of 256 KiB and one sync to disk at the end.

use std::{
    collections::BTreeMap,
    fs::{self, File, Permissions},
    io::{self, BufWriter, Seek, SeekFrom, Write},
    path::{Path, PathBuf},
    sync::{Mutex, MutexGuard, PoisonError},
};

use tempfile::NamedTempFile;

use super::OutputError;

const BUFFER_BYTES: usize = 1 << 18;

/// The temporary files of this process, each with its target path.
static UNFINISHED: Mutex<BTreeMap<PathBuf, PathBuf>> = Mutex::new(BTreeMap::new());

/// Locks the list; no thread panics in the middle of a change.
fn unfinished() -> MutexGuard<'static, BTreeMap<PathBuf, PathBuf>> {
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Removes all unfinished files, for a process that exits at once. Returns their target paths; no other file starts or finishes while the
/// second value is held.
#[must_use]
pub fn abandon_unfinished() -> (Vec<PathBuf>, impl Sized) {
    let listed = unfinished();
    for path in listed.keys() {
        // A file that cannot be removed stays, because the process exits.
        let _ = fs::remove_file(path);
    }
    (listed.values().cloned().collect(), listed)
}

/// An entry in the list of temporary files, which its lifetime limits.
#[derive(Debug)]
struct Listed(PathBuf);

impl Drop for Listed {
    fn drop(&mut self) {
        unfinished().remove(&self.0);
    }
}

/// An unfinished file, which appears at its path on [`finish`](Self::finish).
#[derive(Debug)]
pub struct AtomicFile {
    path: PathBuf,
    target: PathBuf,
    kept_permissions: Option<Permissions>,
    file: BufWriter<NamedTempFile<File>>,
    /// The field follows the file, so that the file is removed before its entry.
    listed: Listed,
}

impl AtomicFile {
    /// Creates a file after a check that `path` is writable.
    ///
    /// Symbolic links are followed, even to a missing file, and a replaced file passes on its permissions.
    ///
    /// # Errors
    ///
    /// Returns [`OutputError::NotAFile`], [`OutputError::ReadOnly`] or [`OutputError::MissingFolder`] for such a path, and
    /// [`OutputError::Create`] if no file can be created in the folder.
    pub fn create(path: &Path) -> Result<Self, OutputError> {
        let target = destination(path);
        let kept_permissions = replaceable(path)?;
        let mut all = unfinished();
        let file = temporary_beside(&target, path)?;
        let temporary = file.path().to_owned();
        all.insert(temporary.clone(), path.to_owned());
        drop(all);
        let file = BufWriter::with_capacity(BUFFER_BYTES, file);
        Ok(Self { path: path.to_owned(), target, kept_permissions, file, listed: Listed(temporary) })
    }

    /// Writes a file with these bytes.
    ///
    /// # Errors
    ///
    /// Returns the errors of [`create`](Self::create) and [`finish`](Self::finish), and [`OutputError::Write`] if writing fails.
    pub fn write_whole(path: &Path, bytes: &[u8]) -> Result<(), OutputError> {
        let mut file = Self::create(path)?;
        file.write_all(bytes).map_err(|error| file.failed(error))?;
        file.finish()
    }

    /// Returns the requested path.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Returns the temporary file, for another program to write.
    pub(super) fn temporary(&self) -> &Path {
        self.file.get_ref().path()
    }

    /// Moves the file to its path and replaces an existing file.
    ///
    /// # Errors
    ///
    /// Returns [`OutputError::Write`] if the rest cannot be written or the file cannot be moved; a file at the path is then unchanged.
    pub fn finish(self) -> Result<(), OutputError> {
        let path = self.path;
        let failed = |cause| OutputError::Write { path: path.clone(), cause };
        let file = self.file.into_inner().map_err(|e| failed(e.into_error()))?;
        if let Some(permissions) = self.kept_permissions {
            file.as_file().set_permissions(permissions).map_err(failed)?;
        }
        file.as_file().sync_all().map_err(failed)?;
        file.persist(&self.target).map_err(|e| failed(e.error))?;
        drop(self.listed);
        Ok(())
    }

    /// Creates a write error with the path.
    pub(crate) fn failed(&self, cause: io::Error) -> OutputError {
        OutputError::Write { path: self.path.clone(), cause }
    }
}

/// The largest number of links in one path, as on Linux.
const LINKS: usize = 40;

/// Returns the file that is written for `path`: symbolic links are followed, even to a missing file.
#[must_use]
pub fn destination(path: &Path) -> PathBuf {
    let mut target = path.to_owned();
    for _ in 0..LINKS {
        let Ok(next) = fs::read_link(&target) else { break };
        target = target.parent().unwrap_or(Path::new("")).join(next);
    }
    fs::canonicalize(&target).unwrap_or(target)
}

/// Returns the permissions of the file at `path`, if it exists, after a check that it may be replaced.
fn replaceable(path: &Path) -> Result<Option<Permissions>, OutputError> {
    let not_a_file = |what| Err(OutputError::NotAFile { path: path.to_owned(), what });
    let ends_in = path.as_os_str().as_encoded_bytes().last();
    if path.file_name().is_none() || ends_in.is_some_and(|end| std::path::is_separator(char::from(*end))) {
        return not_a_file("a folder");
    }
    match fs::metadata(path) {
        Ok(old) if old.is_dir() => not_a_file("a folder"),
        Ok(old) if !old.is_file() => not_a_file("a device or pipe"),
        Ok(old) if old.permissions().readonly() => Err(OutputError::ReadOnly { path: path.to_owned() }),
        Ok(old) => Ok(Some(old.permissions())),
        Err(_) if destination(path).is_symlink() => not_a_file("a symbolic link to itself"),
        // The file is missing or invisible; the creation of the temporary file reports which.
        Err(_) => Ok(None),
    }
}

/// Creates an empty temporary file in the folder of `target`, with the permissions of a new file.
fn temporary_beside(target: &Path, path: &Path) -> Result<NamedTempFile, OutputError> {
    let folder = match target.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    };
    let name = target.file_name().unwrap_or_default().to_string_lossy();
    // File names are limited to 255 bytes on common systems, so only the beginning of a long name is used.
    let prefix: String = [".".into(), name].concat().chars().take(32).collect();
    let mut builder = tempfile::Builder::new();
    builder.prefix(&prefix).suffix(".part");
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    builder.tempfile_in(folder).map_err(|cause| {
        let (path, folder) = (path.to_owned(), folder.to_owned());
        if cause.kind() == io::ErrorKind::NotFound {
            OutputError::MissingFolder { path, folder }
        } else {
            OutputError::Create { path, folder, cause }
        }
    })
}

impl Write for AtomicFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

impl Seek for AtomicFile {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        self.file.seek(to)
    }

    // `BufWriter` returns the position without a flush.
    fn stream_position(&mut self) -> io::Result<u64> {
        self.file.stream_position()
    }
}
