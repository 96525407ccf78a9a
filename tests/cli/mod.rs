//! Tests the command line as users see it, by running the program in a temporary folder.

#![allow(clippy::float_cmp)] // numbers that are exact by design are compared exactly

mod arrays;
mod attacks;
mod bad_files;
mod bad_options;
mod bad_scenes;
mod bench;
mod commands;
mod diagrams;
mod farm;
mod films;
mod frames;
mod help;
mod import;
mod interrupted;
mod json;
mod light;
mod lost_words;
mod maps;
mod measures;
mod parts;
mod paths;
mod pictures;
mod profile;
mod progress;
mod same_files;
mod shutter;
mod slurm;
mod streams;
mod tables;
mod traces;
mod unwritable;

use std::path::PathBuf;
use std::process::{Command, Stdio};

use tempfile::TempDir;

/// A glowing ball in front of a sky, in straight space: one program, and fast.
const BALL: &str = r#"
[image]
size = [16, 12]
[camera]
position = [0, 0, 5]
[rays]
bounding_sphere = { radius = 10 }
[sky]
color = [0.2, 0.3, 0.4]
[materials.red]
kind = "emissive"
color = [1, 0, 0]
[[objects]]
shape = "sphere"
material = "red"
"#;

/// The result of a run.
struct Ran {
    code: Option<i32>,
    out: String,
    err: String,
}

impl Ran {
    /// Checks that the exit code is 0.
    #[track_caller]
    fn succeeds(self) -> Self {
        assert_eq!(self.code, Some(0), "{}", self.err);
        self
    }

    /// Checks that this is the exit code, with nothing on stdout and all of these texts on stderr.
    #[track_caller]
    fn fails(self, code: i32, texts: &[&str]) -> Self {
        assert_eq!(self.code, Some(code), "{}", self.err);
        assert_eq!(self.out, "", "results on stdout in spite of {}", self.err);
        assert!(self.err.starts_with("error: "), "{}", self.err);
        self.says(texts)
    }

    /// Checks that all of these texts are on stderr.
    #[track_caller]
    fn says(self, texts: &[&str]) -> Self {
        for text in texts {
            assert!(self.err.contains(text), "no `{text}` in:\n{}", self.err);
        }
        self
    }
}

/// A temporary folder for one test, in which the program runs.
struct Folder(TempDir);

impl Folder {
    /// Creates an empty folder.
    fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    /// Creates a folder that contains this `scene.toml`.
    fn with(scene: &str) -> Self {
        let folder = Self::new();
        folder.write("scene.toml", scene);
        folder
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn write(&self, name: &str, content: impl AsRef<[u8]>) {
        std::fs::write(self.path(name), content).unwrap();
    }

    fn read(&self, name: &str) -> Vec<u8> {
        std::fs::read(self.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    fn text(&self, name: &str) -> String {
        String::from_utf8(self.read(name)).unwrap()
    }

    /// Returns the names in the folder, sorted.
    fn names(&self) -> Vec<String> {
        let entries = self.0.path().read_dir().unwrap();
        let mut names: Vec<_> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    /// Returns a command with these arguments, separated by spaces, without starting it.
    fn command(&self, arguments: &str) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_bentray"));
        command
            .args(arguments.split_whitespace())
            .current_dir(self.0.path())
            .env("BENTRAY_CACHE", "")
            .stdin(Stdio::null());
        command
    }

    /// Runs the program with these arguments, separated by spaces.
    fn run(&self, arguments: &str) -> Ran {
        let output = self.command(arguments).output().unwrap();
        Ran {
            code: output.status.code(),
            out: String::from_utf8(output.stdout).unwrap(),
            err: String::from_utf8(output.stderr).unwrap(),
        }
    }
}
