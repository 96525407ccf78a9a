//! The arguments that all of `bentray farm` shares: a render, and the number of its parts.

use std::env;
use std::fs;
use std::path::{Path, PathBuf};

use clap::Args;
use serde_json::{Value, json};

use crate::cli::format::{CommandResult, Format, shown};
use crate::cli::frames::Film;
use crate::cli::origin::scene_origin;
use crate::cli::paths;
use crate::cli::render::{self, targets_of};
use crate::cli::share::{Share, Target};
use crate::cli::words::{quoted, typed};
use crate::error::Error;
use crate::output::{AtomicFile, OutputError, settings_of};
use crate::scene::Scene;

/// The options of `farm` that parts do not get: those with a value, and flags.
const OWN: [&str; 7] = ["--parts", "--folder", "--sbatch", "--image", "--volume", "--at-once", "--hosts"];
const ALONE: [&str; 2] = ["--submit", "--json"];

/// The last line in the log of a failed part, before its exit code.
const FAILED: &str = "part failed: exit code ";

/// A render in parts.
#[derive(Debug, Args)]
pub(super) struct Job {
    /// Number of parts into which the animation or the image is divided
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=100_000))]
    parts: u32,
    /// Directory for scripts and logs; by default NAME.farm for a scene NAME.toml
    #[arg(long, value_name = "DIR", value_parser = paths::file())]
    folder: Option<PathBuf>,
    #[command(flatten)]
    render: render::Arguments,
}

impl Job {
    pub(super) fn parts(&self) -> u32 {
        self.parts
    }

    /// Returns the format of results.
    pub(super) fn format(&self) -> Format {
        self.render.format
    }

    /// Reads the scene, and determines the content of each part.
    pub(super) fn load(&self) -> Result<Loaded<'_>, Error> {
        self.render.check_for_farm()?;
        let film = Film::new(&self.render.scene, self.render.changes.overrides()?);
        let scene = film.load(None)?;
        let frames = self.render.frames_of(&scene)?;
        let shares = (0..self.parts).map(|number| Share { number, count: self.parts });
        let shares: Vec<_> = shares.map(|share| targets_of(share, &frames, &scene)).collect::<Result<_, _>>()?;
        for path in shares.iter().flatten().flat_map(|target| self.paths(*target)) {
            let folder = path.parent().filter(|folder| *folder != Path::new("")).map(Path::to_owned);
            if let Some(folder) = folder.filter(|folder| !folder.is_dir()) {
                return Err(OutputError::MissingFolder { path, folder }.into());
            }
        }
        Ok(Loaded { job: self, film, scene, shares })
    }

    /// Returns the files of a target.
    pub(super) fn paths(&self, target: Target) -> Vec<PathBuf> {
        self.render.paths(target)
    }

    /// Returns the name of the scene, which is also the name of the job.
    pub(super) fn name(&self) -> String {
        self.render.scene.file_stem().unwrap_or_default().to_string_lossy().into_owned()
    }

    /// Returns the folder for scripts and logs.
    pub(super) fn folder(&self) -> PathBuf {
        self.folder.clone().unwrap_or_else(|| PathBuf::from(format!("{}.farm", self.name())))
    }

    /// Returns the file for the messages of part `number`, counted from 1.
    pub(super) fn log(&self, number: u32) -> PathBuf {
        self.folder().join(format!("part-{number}.log"))
    }

    /// Writes a file into the folder, and creates the folder if needed. An existing file is replaced, since it has the same source.
    pub(super) fn write(&self, name: &str, text: &str) -> Result<PathBuf, Error> {
        let folder = self.folder();
        let path = folder.join(name);
        let failed = |cause| OutputError::Create { path: path.clone(), folder: folder.clone(), cause };
        fs::create_dir_all(&folder).map_err(failed)?;
        AtomicFile::write_whole(&path, text.as_bytes())?;
        Ok(path)
    }
}

/// A job with its scene.
pub(super) struct Loaded<'a> {
    job: &'a Job,
    film: Film<'a>,
    scene: Scene,
    /// The targets that each part renders.
    pub shares: Vec<Vec<Target>>,
}

impl Loaded<'_> {
    /// Makes the requested videos from frames that all exist.
    pub(super) fn make_films(&self, pictures: &[Target]) -> Result<(), Error> {
        match &self.scene.animation {
            Some(animation) => self.job.render.make_films(pictures, animation.rate),
            None => Ok(()),
        }
    }

    /// Returns `true` if all files of a target exist and are from this scene.
    pub(super) fn is_there(&self, target: Target) -> Result<bool, Error> {
        let paths = self.job.paths(target);
        let found: Vec<_> = paths.iter().filter_map(|path| settings_of(path).ok()).collect();
        if found.len() < paths.len() {
            return Ok(false);
        }
        let wanted = scene_origin(&self.film, target.frame, &self.scene)?;
        Ok(found.iter().all(|found| wanted.iter().all(|(key, text)| found.said(key) == Some(text))))
    }
}

/// Returns the path of this program, for machines that have it at the same path.
pub(super) fn program() -> String {
    env::current_exe().map_or_else(|_| "bentray".to_owned(), |path| path.display().to_string())
}

/// Returns the arguments that were typed for `render`.
fn words() -> Vec<String> {
    typed(3, &OWN, &ALONE)
}

/// Returns the command line that renders a part; `part` is its name in the shell or the queue.
pub(super) fn render_words(program: &str, part: &str) -> Vec<String> {
    let own = [program.to_owned(), "render".to_owned()];
    own.into_iter().chain(words()).chain(["--part".to_owned(), part.to_owned()]).collect()
}

/// Returns a shell command that reports a failure of `command`, in a form that [`failure`] finds.
pub(super) fn or_say(command: &str) -> String {
    format!("{command} || {{ code=$?; echo \"{FAILED}$code\"; exit $code; }}")
}

/// Returns the last error in the log of a failed part, or else its exit code; `None` if the part did not fail.
pub(super) fn failure(log: &str) -> Option<&str> {
    let code = log.lines().last()?.strip_prefix(FAILED)?;
    let ours = |line: &&str| line.starts_with("error: ");
    Some(log.lines().rev().find(ours).unwrap_or(code))
}

/// Returns the command line that combines all parts.
pub(super) fn finish_words(program: &str, parts: u32) -> Vec<String> {
    let own = [program, "farm", "finish"].map(str::to_owned);
    own.into_iter().chain(words()).chain(["--parts".to_owned(), parts.to_string()]).collect()
}

/// Returns the command line that prints the progress, for people to type.
fn status_line(parts: u32) -> String {
    let own = ["bentray", "farm", "status"].map(str::to_owned);
    let words: Vec<String> = own.into_iter().chain(words()).chain(["--parts".to_owned(), parts.to_string()]).collect();
    quoted(&words)
}

/// The files written for a queue, and the commands left to type.
pub(super) struct Written {
    files: Vec<PathBuf>,
    /// The commands that submit the job to the queue, in order.
    commands: Vec<String>,
    /// The command that prints the progress.
    status: String,
}

impl Written {
    pub(super) fn new(parts: u32, files: Vec<PathBuf>, commands: Vec<String>) -> Self {
        Self { files, commands, status: status_line(parts) }
    }
}

impl CommandResult for Written {
    fn text(&self) -> String {
        let files: Vec<String> = self.files.iter().map(shown).collect();
        let commands: Vec<String> = self.commands.iter().map(|command| format!("`{command}`")).collect();
        let submit = (!commands.is_empty()).then(|| format!("\nsubmit with {}", commands.join(", then ")));
        format!(
            "wrote {}{}\nprint the progress, on a machine that has the files, with `{}`",
            files.join(", "),
            submit.unwrap_or_default(),
            self.status
        )
    }

    fn json(&self) -> Value {
        let files: Vec<String> = self.files.iter().map(shown).collect();
        json!({ "files": files, "commands": self.commands, "status": self.status })
    }
}

/// Formats numbers in the syntax of queues: `1,3-5`.
pub(super) fn ranges(numbers: &[u32]) -> String {
    let mut sorted = numbers.to_vec();
    sorted.sort_unstable();
    let words = sorted.chunk_by(|a, b| a + 1 == *b).map(|run| match run {
        [first, .., last] => format!("{first}-{last}"),
        run => run.iter().map(u32::to_string).collect(),
    });
    words.collect::<Vec<_>>().join(",")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_failed_part_says_why() {
        assert_eq!(failure("error: of a driver\ndevice: x\n"), None);
        assert_eq!(failure("error: a\nerror: b\n  c\npart failed: exit code 1\n"), Some("error: b"));
        assert_eq!(failure("Killed\npart failed: exit code 137"), Some("137"));
        assert_eq!(failure(""), None);
        assert_eq!(or_say("a b"), "a b || { code=$?; echo \"part failed: exit code $code\"; exit $code; }");
    }

    #[test]
    fn numbers_are_written_as_queues_take_them() {
        assert_eq!(ranges(&[1, 3, 4, 5, 9, 8]), "1,3-5,8-9");
        assert_eq!(ranges(&[0]), "0");
        assert_eq!(ranges(&[]), "");
    }
}
