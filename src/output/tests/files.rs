//! Tests of files that are written completely or not at all.

use std::{
    fs,
    io::{Seek, SeekFrom, Write},
    path::Path,
};

use super::{folder, names};
use crate::output::{AtomicFile, FileSettings, OutputError, open};
use crate::program::Layer;

#[test]
fn appears_when_finished() {
    let folder = folder();
    let path = folder.path().join("a.txt");
    let mut file = AtomicFile::create(&path).unwrap();
    file.write_all(b"xbc").unwrap();
    assert_eq!(file.stream_position().unwrap(), 3);
    file.seek(SeekFrom::Start(0)).unwrap();
    file.write_all(b"a").unwrap();
    assert!(!path.exists());
    file.finish().unwrap();
    assert_eq!(fs::read(&path).unwrap(), b"abc");
    assert_eq!(names(folder.path()), [Path::new("a.txt")]);
}

#[test]
fn an_interrupted_write_leaves_the_old_file() {
    let folder = folder();
    let path = folder.path().join("a.txt");
    fs::write(&path, "old").unwrap();
    let mut file = AtomicFile::create(&path).unwrap();
    file.write_all(&vec![b'n'; 1 << 20]).unwrap();
    drop(file);
    assert_eq!(fs::read(&path).unwrap(), b"old");
    assert_eq!(names(folder.path()), [Path::new("a.txt")]);
}

#[test]
fn refuses_what_cannot_be_a_file() {
    let folder = folder();
    let taken = AtomicFile::create(folder.path()).unwrap_err();
    assert!(matches!(taken, OutputError::NotAFile { .. }), "{taken}");
    let nameless = AtomicFile::create(Path::new("")).unwrap_err();
    assert!(matches!(nameless, OutputError::NotAFile { .. }), "{nameless}");
    let lost = AtomicFile::create(&folder.path().join("no/a.txt")).unwrap_err();
    assert!(matches!(lost, OutputError::MissingFolder { .. }), "{lost}");
    fs::write(folder.path().join("file"), "").unwrap();
    let under_file = AtomicFile::create(&folder.path().join("file/a.txt")).unwrap_err();
    assert!(matches!(under_file, OutputError::Create { .. }), "{under_file}");
    for error in [taken, lost, under_file] {
        let path = folder.path().display().to_string();
        assert!(error.to_string().starts_with(&path), "{error}");
    }
}

#[test]
fn writes_in_the_current_folder() {
    // If dropped unfinished, the file leaves nothing behind.
    AtomicFile::create(Path::new("bentray-output-test.txt")).unwrap();
}

#[cfg(unix)]
mod unix {
    use std::os::unix::fs::{PermissionsExt, symlink};

    use super::*;

    fn mode(path: &Path) -> u32 {
        fs::metadata(path).unwrap().permissions().mode() & 0o777
    }

    fn set_mode(path: &Path, mode: u32) {
        fs::set_permissions(path, fs::Permissions::from_mode(mode)).unwrap();
    }

    #[test]
    fn a_new_file_has_the_usual_permissions_and_an_old_one_keeps_its_own() {
        let folder = folder();
        let usual = folder.path().join("usual");
        fs::write(&usual, "").unwrap();
        let path = folder.path().join("a");
        AtomicFile::create(&path).unwrap().finish().unwrap();
        assert_eq!(mode(&path), mode(&usual));
        set_mode(&path, 0o640);
        AtomicFile::create(&path).unwrap().finish().unwrap();
        assert_eq!(mode(&path), 0o640);
    }

    #[test]
    fn refuses_read_only_files_and_devices() {
        let folder = folder();
        let path = folder.path().join("a");
        fs::write(&path, "old").unwrap();
        set_mode(&path, 0o444);
        let error = AtomicFile::create(&path).unwrap_err();
        assert!(matches!(error, OutputError::ReadOnly { .. }), "{error}");
        let error = AtomicFile::create(Path::new("/dev/null")).unwrap_err();
        assert!(matches!(error, OutputError::NotAFile { .. }), "{error}");
    }

    #[test]
    fn refuses_a_folder_without_permission() {
        let folder = folder();
        set_mode(folder.path(), 0o555);
        // The superuser may write anywhere.
        if fs::write(folder.path().join("probe"), "").is_err() {
            let error = AtomicFile::create(&folder.path().join("a")).unwrap_err();
            assert!(matches!(error, OutputError::Create { .. }), "{error}");
        }
        set_mode(folder.path(), 0o755);
    }

    #[test]
    fn follows_a_link() {
        let folder = folder();
        let (target, link) = (folder.path().join("target"), folder.path().join("link"));
        fs::write(&target, "old").unwrap();
        symlink(&target, &link).unwrap();
        let mut file = AtomicFile::create(&link).unwrap();
        file.write_all(b"new").unwrap();
        file.finish().unwrap();
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        assert_eq!(fs::read(&target).unwrap(), b"new");
    }
}

#[test]
fn settings_are_checked_at_the_start() {
    let folder = folder();
    let refused = |name: &str, change: &dyn Fn(&mut FileSettings)| {
        let mut settings = FileSettings::new([4, 4]);
        change(&mut settings);
        let path = folder.path().join(name);
        let error = open(&path, &settings).map(|_| ()).unwrap_err().to_string();
        assert!(error.starts_with(&path.display().to_string()), "{error}");
    };
    refused("a.jpg", &|_| ());
    refused("a", &|_| ());
    refused("no/a.png", &|_| ());
    refused("a.png", &|s| s.size = [0, 4]);
    refused("a.exr", &|s| s.size = [4, u32::MAX]);
    refused("a.png", &|s| s.bits = 12);
    refused("a.png", &|s| s.exposure = f64::NAN);
    refused("a.png", &|s| s.layers = vec![Layer::Segments]);
    refused("a.png", &|s| s.metadata = vec![(String::new(), "b".into())]);
    refused("a.exr", &|s| s.metadata = vec![("a".into(), "b\0".into())]);
    refused("a.exr", &|s| s.metadata = vec![("a".into(), "b".into()); 2]);
    refused("a.exr", &|s| s.metadata = vec![("channels".into(), "b".into())]);
    assert!(names(folder.path()).is_empty());
}
