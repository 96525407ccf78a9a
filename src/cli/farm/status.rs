//! `bentray farm status`: prints the progress of a render in parts.

use std::fs;

use serde_json::{Value, json};

use super::job::{Job, Loaded, failure, ranges};
use crate::cli::format::CommandResult;
use crate::cli::share::Target;
use crate::error::Error;

/// The state of a part.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum State {
    Done,
    Failed,
    UnderWay,
    Missing,
}

impl State {
    const ALL: [Self; 4] = [Self::Done, Self::Failed, Self::UnderWay, Self::Missing];

    /// Returns the name of the state in JSON.
    fn name(self) -> &'static str {
        match self {
            Self::Done => "done",
            Self::Failed => "failed",
            Self::UnderWay => "running",
            Self::Missing => "pending",
        }
    }

    fn words(self) -> &'static str {
        match self {
            Self::Done => "done",
            Self::Failed => "failed",
            Self::UnderWay => "running or interrupted",
            Self::Missing => "not started",
        }
    }
}

/// A part of a job.
struct JobPart {
    /// The number of the part, from 1.
    number: u32,
    state: State,
    /// The reason of a failure, if the part failed.
    error: Option<String>,
}

/// All parts of a job.
struct Progress(Vec<JobPart>);

pub(super) fn run(job: &Job) -> Result<(), Error> {
    let loaded = job.load()?;
    let part = |(number, targets): (u32, &Vec<Target>)| JobPart::look(job, &loaded, number, targets);
    let parts: Vec<JobPart> = (1..).zip(&loaded.shares).map(part).collect::<Result<_, _>>()?;
    job.format().say(&Progress(parts))
}

impl JobPart {
    fn look(job: &Job, loaded: &Loaded, number: u32, targets: &[Target]) -> Result<Self, Error> {
        let log = fs::read_to_string(job.log(number)).ok();
        let error = log.as_deref().and_then(failure);
        let mut is_done = true;
        for target in targets {
            is_done &= self::is_done(loaded, *target)?;
        }
        let state = match (&log, error) {
            _ if is_done => State::Done,
            (_, Some(_)) => State::Failed,
            (Some(_), None) => State::UnderWay,
            (None, None) => State::Missing,
        };
        Ok(Self { number, state, error: error.filter(|_| state == State::Failed).map(str::to_owned) })
    }
}

/// Returns `true` if the files of a target exist, or those of the image to which its band belongs.
fn is_done(loaded: &Loaded, target: Target) -> Result<bool, Error> {
    Ok(loaded.is_there(target)? || loaded.is_there(Target { band: None, ..target })?)
}

impl Progress {
    /// Returns the numbers of the parts in a state.
    fn numbers(&self, state: State) -> Vec<u32> {
        self.0.iter().filter(|part| part.state == state).map(|part| part.number).collect()
    }
}

impl CommandResult for Progress {
    fn text(&self) -> String {
        let mut lines = vec![format!("{} of {} parts are done", self.numbers(State::Done).len(), self.0.len())];
        for state in State::ALL.into_iter().filter(|state| *state != State::Done) {
            let numbers = self.numbers(state);
            if !numbers.is_empty() {
                lines.push(format!("{}: {} ({})", state.words(), numbers.len(), ranges(&numbers)));
            }
        }
        let reason = |part: &JobPart| Some(format!("part {}: {}", part.number, part.error.as_ref()?));
        lines.extend(self.0.iter().filter_map(reason));
        lines.join("\n")
    }

    fn json(&self) -> Value {
        let part = |part: &JobPart| json!({ "part": part.number, "state": part.state.name(), "error": part.error });
        json!({
            "count": State::ALL.map(|state| (state.name(), self.numbers(state).len())).into_iter().collect::<Value>(),
            "parts": self.0.iter().map(part).collect::<Vec<_>>(),
        })
    }
}
