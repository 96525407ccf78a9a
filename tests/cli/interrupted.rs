//! A file is written completely or not at all, even if the program is killed or asked to end. The tests start it with GNU `env`.

#![cfg(target_os = "linux")]

use std::io::{BufRead, BufReader, Read};
use std::process::{Child, ChildStderr, Command, Stdio};
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

/// A render that takes minutes.
const LONG: &str = "render scene.toml -o a.png -o a.exr --size 4000x3000 --samples 16384 --set law.kind=schwarzschild --set law.mass=0.1";

/// Returns a command that ignores these signals and handles all others by default, whatever started the tests: `nohup` and
/// a shell's `&` make programs ignore signals.
fn with_signals(folder: &Folder, ignored: &str, arguments: &str) -> Command {
    let program = folder.command(arguments);
    let mut command = Command::new("env");
    command.arg("--default-signal=HUP,INT,TERM");
    if !ignored.is_empty() {
        command.arg(format!("--ignore-signal={ignored}"));
    }
    command.arg(program.get_program()).args(program.get_args()).current_dir(folder.path("."));
    command.envs(program.get_envs().filter_map(|(name, value)| Some((name, value?)))).stdin(Stdio::null());
    command
}

/// Starts the long render with these signals ignored, and waits until both files are being written.
fn begin(folder: &Folder, ignored: &str) -> (Killed, BufReader<ChildStderr>) {
    let mut command = with_signals(folder, ignored, LONG);
    let mut child = Killed(command.stderr(Stdio::piped()).spawn().unwrap());
    let mut lines = BufReader::new(child.0.stderr.take().unwrap());
    let mut line = String::new();
    lines.read_line(&mut line).unwrap();
    assert!(line.starts_with("device: "), "{line}");
    // The files are now open under temporary names; a little later rays are being traced.
    let until = Instant::now() + Duration::from_secs(10);
    while unfinished(folder) < 2 && Instant::now() < until {
        sleep(Duration::from_millis(10));
    }
    assert_eq!(unfinished(folder), 2, "{:?}", folder.names());
    sleep(Duration::from_millis(500));
    assert!(child.0.try_wait().unwrap().is_none(), "it ended before it was stopped");
    (child, lines)
}

fn unfinished(folder: &Folder) -> usize {
    ending(folder, ".part").len()
}

/// Returns the names in a folder that end this way.
fn ending(folder: &Folder, end: &str) -> Vec<String> {
    folder.names().into_iter().filter(|name| name.ends_with(end)).collect()
}

#[test]
fn a_render_that_is_killed_leaves_the_old_files_whole() {
    let folder = Folder::with(BALL);
    folder.run("render scene.toml -o a.png -o a.exr").succeeds();
    let old = [folder.read("a.png"), folder.read("a.exr")];
    let (child, _lines) = begin(&folder, "");
    drop(child);
    assert!(old == [folder.read("a.png"), folder.read("a.exr")]);
    // The next run is not obstructed by the remains.
    folder.run("render scene.toml -o a.png -o a.exr --size 8x8").succeeds();
    assert!(old != [folder.read("a.png"), folder.read("a.exr")]);
}

#[test]
fn a_render_that_is_asked_to_end_leaves_nothing_behind() {
    let folder = Folder::with(BALL);
    folder.write("a.png", "an old picture");
    for (signal, code) in [("INT", 130), ("TERM", 143), ("HUP", 129)] {
        let (mut child, mut lines) = begin(&folder, "");
        send(signal, &child.0);
        assert_eq!(child.0.wait().unwrap().code(), Some(code), "{signal}");
        let mut rest = String::new();
        lines.read_to_string(&mut rest).unwrap();
        let line = format!(
            "stopped by SIG{signal}; a.exr, a.png were not finished; earlier files with these names are unchanged\n"
        );
        assert!(rest.ends_with(&line), "{signal}: {rest}");
        assert_eq!(folder.names(), ["a.png", "scene.toml"], "{signal}: {rest}");
        assert_eq!(folder.text("a.png"), "an old picture");
    }
}

/// `nohup` makes it ignore SIGHUP, and a shell without job control makes commands in the background ignore SIGINT.
#[test]
fn signals_that_were_ignored_before_stay_so() {
    let folder = Folder::with(BALL);
    let (mut child, mut lines) = begin(&folder, "HUP,INT");
    for signal in ["HUP", "INT"] {
        send(signal, &child.0);
        sleep(Duration::from_millis(200));
        assert!(child.0.try_wait().unwrap().is_none(), "it ended at SIG{signal}");
    }
    send("TERM", &child.0);
    assert_eq!(child.0.wait().unwrap().code(), Some(143));
    let mut rest = String::new();
    lines.read_to_string(&mut rest).unwrap();
    assert!(rest.contains("stopped by SIGTERM") && !rest.contains("SIGHUP") && !rest.contains("SIGINT"), "{rest}");
}

#[test]
fn a_film_that_is_asked_to_end_finishes_the_frame_in_hand() {
    let animation =
        "[animation]\nframes = 500\n[[animation.tracks]]\nkey = \"camera.position\"\nvalues = [[0, 0, 5], [1, 0, 5]]\n";
    let folder = Folder::with(&(BALL.to_owned() + animation));
    let film = "render scene.toml -o {frame:3}.png --frames all --size 300x200 --samples 4";
    let mut child = Killed(with_signals(&folder, "", film).stderr(Stdio::piped()).spawn().unwrap());
    let mut lines = BufReader::new(child.0.stderr.take().unwrap()).lines().map_while(Result::ok);
    assert!(lines.any(|line| line.starts_with("frame 1: ")));
    send("INT", &child.0);
    let rest: Vec<String> = lines.collect();
    assert_eq!(child.0.wait().unwrap().code(), Some(130));
    assert!(
        rest.iter().any(|line| line == "SIGINT: stopping after this frame; send it again to stop immediately"),
        "{rest:?}"
    );
    let frames = ending(&folder, ".png");
    assert!((2..400).contains(&frames.len()), "{frames:?}");
    let there =
        format!("stopped by SIGINT; {} of 500 frames are on disk; run the command again to continue", frames.len());
    assert!(rest.contains(&there), "{rest:?}");
    assert_eq!(frames.len() + 1, folder.names().len(), "{:?}", folder.names());
    // Each frame is a complete image.
    for name in frames {
        assert!(image::load_from_memory(&folder.read(&name)).is_ok(), "{name}");
    }
}

fn send(signal: &str, child: &Child) {
    let status = Command::new("kill").args(["-s", signal, &child.id().to_string()]).status().unwrap();
    assert!(status.success());
}

#[test]
fn a_new_picture_takes_the_old_ones_place() {
    let folder = Folder::with(BALL);
    folder.write("a.png", "an old picture");
    folder.run("render scene.toml -o a.png").succeeds();
    assert!(folder.read("a.png").starts_with(b"\x89PNG"));
    assert_eq!(folder.names(), ["a.png", "scene.toml"]);
}

/// A video that is killed at any moment has only complete frames, and the same command then makes the same file as an uninterrupted one.
#[test]
fn a_film_that_is_killed_goes_on_to_the_same_bytes() {
    const FILM: &str =
        "[animation]\nframes = 8\n[[animation.tracks]]\nkey = \"sky.color\"\nvalues = [[0, 0, 0], [1, 1, 1]]\n";
    let film = "render scene.toml -o {frame}.exr -o film.png --frames all --size 200x150 --samples 4";
    let whole = Folder::with(&format!("{BALL}{FILM}"));
    whole.run(film).succeeds();
    let folder = Folder::with(&format!("{BALL}{FILM}"));
    for pause in [40, 230, 110, 320, 170] {
        let child = Killed(folder.command(film).stderr(Stdio::null()).spawn().unwrap());
        sleep(Duration::from_millis(pause));
        drop(child);
        for name in ending(&folder, ".exr") {
            assert!(folder.read(&name) == whole.read(&name), "{name}");
        }
    }
    folder.run(film).succeeds();
    let done = |folder: &Folder| folder.names().into_iter().filter(|name| !name.starts_with('.')).collect::<Vec<_>>();
    assert_eq!(done(&folder), done(&whole));
    for name in done(&whole) {
        assert!(folder.read(&name) == whole.read(&name), "{name}");
    }
}
