//! `bentray farm finish`: combines parts into images, and checks the animation.

use std::collections::BTreeMap;
use std::path::PathBuf;

use serde_json::{Value, json};

use super::job::{Job, ranges};
use crate::cli::format::{CommandResult, shown};
use crate::cli::share::Target;
use crate::error::Error;
use crate::output::origin::{LINES, SCENE, difference};
use crate::output::{OutputError, merge, settings_of};

pub(super) fn run(job: &Job) -> Result<(), Error> {
    let loaded = job.load()?;
    let shares = &loaded.shares;
    let mut missing: Vec<u32> = Vec::new();
    for (number, targets) in (1..).zip(shares) {
        let there: Vec<bool> = targets.iter().map(|target| loaded.is_there(*target)).collect::<Result<_, _>>()?;
        missing.extend(there.contains(&false).then_some(number));
    }
    if !missing.is_empty() {
        let (count, all) = (missing.len(), shares.len());
        let problem = format!(
            "{count} of {all} parts are missing or belong to another scene: {}; run them again",
            ranges(&missing)
        );
        return Err(Error::Usage(problem));
    }
    let mut bands: BTreeMap<Option<u32>, Vec<PathBuf>> = BTreeMap::new();
    for target in shares.iter().flatten() {
        let files = bands.entry(target.frame).or_default();
        files.extend(target.band.into_iter().flat_map(|_| job.paths(*target)));
    }
    let mut pictures = Vec::new();
    for (frame, files) in &bands {
        let outputs = job.paths(Target { frame: *frame, band: None });
        if !files.is_empty() {
            merge(files, &outputs)?;
        }
        pictures.extend(outputs);
    }
    check_alike(&pictures)?;
    let frames: Vec<Target> = bands.keys().map(|frame| Target { frame: *frame, band: None }).collect();
    loaded.make_films(&frames)?;
    job.format().say(&Whole { count: bands.len(), files: pictures })
}

/// The images that were combined from parts.
struct Whole {
    count: usize,
    /// The files of all images; an image may have several.
    files: Vec<PathBuf>,
}

impl CommandResult for Whole {
    fn text(&self) -> String {
        format!("{} images, all present and consistent", self.count)
    }

    fn json(&self) -> Value {
        json!({ "images": self.count, "files": self.files.iter().map(shown).collect::<Vec<_>>() })
    }
}

/// Checks that all images are from one render; frames may differ only in the content of the scene.
fn check_alike(pictures: &[PathBuf]) -> Result<(), Error> {
    let Some(first) = pictures.first() else { return Ok(()) };
    let said = settings_of(first)?.metadata;
    for path in pictures {
        let own = settings_of(path)?.metadata;
        if let Some(found) = difference([&own, &said], &[SCENE, LINES]) {
            let (key, [this, that]) = (&found.key, [0, 1].map(|which| found.value(which)));
            let problem = format!(
                "its `{key}` is {this}, but that of {} is {that}; render it again under the conditions of the others",
                first.display()
            );
            return Err(OutputError::Part { path: path.clone(), problem }.into());
        }
    }
    Ok(())
}
