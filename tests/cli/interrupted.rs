//! A file is written whole or not at all, also if the program is killed.

use std::io::{BufRead, BufReader, Read};
use std::process::{Child, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use super::{BALL, Folder};

/// A child that does not outlive the test.
struct Killed(Child);

impl Drop for Killed {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

#[test]
fn a_render_that_is_killed_leaves_the_old_files_whole() {
    let folder = Folder::with(BALL);
    folder.run("render scene.toml -o a.png -o a.exr").succeeds();
    let old = [folder.read("a.png"), folder.read("a.exr")];
    // Minutes of work.
    let long = "--size 800x600 --samples 4096 --set law.kind=schwarzschild --set law.mass=0.1";
    let mut command = folder.command(&format!("render scene.toml -o a.png -o a.exr {long}"));
    let mut child = Killed(command.stderr(Stdio::piped()).spawn().unwrap());
    let mut lines = BufReader::new(child.0.stderr.take().unwrap());
    let mut line = String::new();
    lines.read_line(&mut line).unwrap();
    assert!(line.starts_with("device: "), "{line}");
    // The files are open by now, under other names; a little later rays are on their way.
    let temporary = |end: &str| {
        let names = folder.names();
        names.iter().filter(|name| name.ends_with(end)).count()
    };
    let until = Instant::now() + Duration::from_secs(10);
    while temporary(".part") < 2 && Instant::now() < until {
        sleep(Duration::from_millis(10));
    }
    assert_eq!(temporary(".part"), 2, "{:?}", folder.names());
    sleep(Duration::from_secs(1));
    let running = child.0.try_wait().unwrap().is_none();
    drop(child);
    let mut rest = String::new();
    lines.read_to_string(&mut rest).unwrap();
    assert!(running, "it ended before it was killed: {rest}");
    assert!(old == [folder.read("a.png"), folder.read("a.exr")]);
    // Nothing of it is in the way of the next run.
    folder.run("render scene.toml -o a.png -o a.exr --size 8x8").succeeds();
    assert!(old != [folder.read("a.png"), folder.read("a.exr")]);
}

#[test]
fn a_new_picture_takes_the_old_ones_place() {
    let folder = Folder::with(BALL);
    folder.write("a.png", "an old picture");
    folder.run("render scene.toml -o a.png").succeeds();
    assert!(folder.read("a.png").starts_with(b"\x89PNG"));
    assert_eq!(folder.names(), ["a.png", "scene.toml"]);
}
