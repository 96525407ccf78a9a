//! Progress on a terminal: a line during the work, and no trace of it afterwards.

#![cfg(target_os = "linux")]

use std::io::Read;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use super::{BALL, Folder};

/// Minutes of work on a CPU, and seconds on any device.
const LONG: &str = "--size 800x600 --samples 4096 --set law.kind=schwarzschild --set law.mass=0.1";

/// Starts the program on a terminal of this type, which `script` of util-linux provides.
fn on_terminal(folder: &Folder, term: &str, arguments: &str) -> Child {
    // When `script` is killed the terminal closes, which ends the program unless a parent made it ignore that signal.
    let line = format!("exec env --default-signal=HUP {} {arguments}", env!("CARGO_BIN_EXE_bentray"));
    Command::new("script")
        .args(["-qefc", &line, "/dev/null"])
        .current_dir(folder.path("."))
        .envs([("NODEVICE_SELECT", "1"), ("BENTRAY_CACHE", ""), ("TERM", term), ("NO_COLOR", "1")])
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap()
}

/// Returns `true` if a text has a code that changes colors.
fn has_color(text: &str) -> bool {
    let is_parameter = |c: char| c.is_ascii_digit() || c == ';';
    text.split("\u{1b}[").skip(1).any(|code| code.trim_start_matches(is_parameter).starts_with('m'))
}

#[test]
fn a_terminal_shows_how_far_a_render_has_come() {
    let folder = Folder::with(BALL);
    let mut child = on_terminal(&folder, "xterm", &format!("render scene.toml -o a.png {LONG}"));
    let (mut text, mut bytes) = (String::new(), [0; 4096]);
    let until = Instant::now() + Duration::from_secs(60);
    // After the search for a method and some samples, the line has a percentage and the remaining time.
    while !text.contains(" %  rendering, about ") && Instant::now() < until {
        let count = child.stdout.as_mut().unwrap().read(&mut bytes).unwrap();
        assert_ne!(count, 0, "it ended: {text}");
        text.push_str(&String::from_utf8_lossy(&bytes[..count]));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    assert!(text.contains(" %  rendering, about "), "{text}");
    assert!(!has_color(&text), "{text:?}");
}

#[test]
fn a_render_leaves_its_messages_on_a_terminal_and_nothing_else() {
    let folder = Folder::with(BALL);
    for term in ["xterm", "dumb"] {
        let child = on_terminal(&folder, term, "render scene.toml -o a.png --samples 100");
        let out = child.wait_with_output().unwrap();
        let text = String::from_utf8(out.stdout).unwrap();
        assert!(out.status.success(), "{text}");
        // Earlier text on a line that was cleared is not visible.
        let lines = text.lines().map(|line| line.rsplit("\u{1b}[2K").next().unwrap_or(line));
        let words: Vec<_> = lines.map(|line| line.split([':', ' ']).next().unwrap_or(line)).collect();
        assert_eq!(words, ["device", "first", "reproduce", "19200"], "{text:?}");
        assert!(term != "dumb" || !text.contains('\u{1b}'), "{text:?}");
    }
}
