//! Tests closed or full message streams: the image is written in any case.

use std::fs::File;
use std::process::Stdio;

use super::{BALL, Folder};

const LONG: &str = "render scene.toml -o a.exr --verify 10";

#[test]
fn a_picture_is_written_though_nobody_reads_its_messages() {
    let folder = Folder::with(BALL);
    folder.run("render scene.toml -o b.exr --verify 10").succeeds();
    for line in [LONG.to_owned(), format!("{LONG} --json")] {
        let mut child = folder.command(&line).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        // Both pipes are closed from the start.
        drop((child.stdout.take(), child.stderr.take()));
        assert_eq!(child.wait().unwrap().code(), Some(0));
        assert!(folder.read("a.exr") == folder.read("b.exr"));
        std::fs::remove_file(folder.path("a.exr")).unwrap();
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_picture_is_written_though_its_messages_find_no_room() {
    let folder = Folder::with(BALL);
    let full = || File::options().write(true).open("/dev/full").unwrap();
    let status = folder.command("render scene.toml -o a.exr").stderr(full()).status().unwrap();
    assert_eq!(status.code(), Some(0));
    assert_eq!(folder.names(), ["a.exr", "scene.toml"]);
    // An error cannot be printed either, but it sets the exit code.
    let status = folder.command("render none.toml -o b.exr").stderr(full()).status().unwrap();
    assert_eq!(status.code(), Some(1));
}
