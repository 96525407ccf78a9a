//! A file that is written whole or not at all.
//!
//! The bytes go to a temporary file in the target's own folder, which is renamed over the target when it is finished:
//! whoever reads the target sees the old file or the new one, never a part. Dropped unfinished, the temporary file is
//! removed and the target is as it was. A process that is interrupted removes what is unfinished by [`abandon_unfinished`]; one that is
//! killed outright may leave the temporary file, whose name begins with a dot and ends in `.part`. The cost is one buffer of 256 KiB and, at the end, one wait for the disk.

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

/// Temporary files of this process, each with the path that it is to have.
static UNFINISHED: Mutex<BTreeMap<PathBuf, PathBuf>> = Mutex::new(BTreeMap::new());

/// No thread leaves it half changed.
fn unfinished() -> MutexGuard<'static, BTreeMap<PathBuf, PathBuf>> {
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Removes every file that is not finished, for a process that ends at once. Returns the paths that they were to have; no other file
/// begins or is finished while the second value is held.
#[must_use]
pub fn abandon_unfinished() -> (Vec<PathBuf>, impl Sized) {
    let listed = unfinished();
    for path in listed.keys() {
        // What cannot be removed stays: there is nobody left to do more.
        let _ = fs::remove_file(path);
    }
    (listed.values().cloned().collect(), listed)
}

/// A place in the list of temporary files, for as long as it is held.
#[derive(Debug)]
struct Listed(PathBuf);

impl Drop for Listed {
    fn drop(&mut self) {
        unfinished().remove(&self.0);
    }
}

/// A file in the making; it appears at its path on [`finish`](Self::finish).
#[derive(Debug)]
pub struct AtomicFile {
    path: PathBuf,
    target: PathBuf,
    kept_permissions: Option<Permissions>,
    file: BufWriter<NamedTempFile<File>>,
    /// Behind the file, which is removed while it is listed still.
    listed: Listed,
}

impl AtomicFile {
    /// Makes sure that `path` can be written, and begins.
    ///
    /// A symbolic link is followed, also to where there is no file yet, and a file that is replaced passes on its permissions.
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
    pub fn write_whole(path: &Path, bytes: &[u8]) -> Result<(), OutputError> {
        let mut file = Self::create(path)?;
        file.write_all(bytes).map_err(|error| file.failed(error))?;
        file.finish()
    }

    /// The path that was asked for.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The temporary file, for another program to write.
    pub(super) fn temporary(&self) -> &Path {
        self.file.get_ref().path()
    }

    /// Puts the file in place of whatever file stood there.
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

    /// Names the path in an error of writing.
    pub(crate) fn failed(&self, cause: io::Error) -> OutputError {
        OutputError::Write { path: self.path.clone(), cause }
    }
}

/// The links that one path may lead through, as on Linux.
const LINKS: usize = 40;

/// Returns the path of the file that is written where `path` is: symbolic links are followed, also to where there is no file yet.
#[must_use]
pub fn destination(path: &Path) -> PathBuf {
    let mut target = path.to_owned();
    for _ in 0..LINKS {
        let Ok(next) = fs::read_link(&target) else { break };
        target = target.parent().unwrap_or(Path::new("")).join(next);
    }
    fs::canonicalize(&target).unwrap_or(target)
}

/// The permissions of the file at `path`, if there is one, after a check that it may be replaced.
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
        // Not there, or not to be seen: making the temporary file tells which.
        Err(_) => Ok(None),
    }
}

/// An empty temporary file in the folder of `target`, with the permissions of any new file.
fn temporary_beside(target: &Path, path: &Path) -> Result<NamedTempFile, OutputError> {
    let folder = match target.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    };
    let name = target.file_name().unwrap_or_default().to_string_lossy();
    // File names end at 255 bytes on common systems, so a long one lends only its beginning.
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

    // `BufWriter` answers this without flushing.
    fn stream_position(&mut self) -> io::Result<u64> {
        self.file.stream_position()
    }
}
