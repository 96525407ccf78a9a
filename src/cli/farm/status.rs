//! `bentray farm status`: how far a film or a picture is that is rendered in parts.

use std::fs;
use std::process::ExitCode;

use super::job::{Job, Loaded, failure, ranges};
use crate::cli::share::Target;
use crate::error::Error;

/// What a part is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum State {
    Done,
    Failed,
    UnderWay,
    Missing,
}

pub(super) fn run(job: &Job) -> Result<ExitCode, Error> {
    let mut parts: Vec<(u32, State)> = Vec::new();
    let mut reasons = Vec::new();
    let loaded = job.load()?;
    for (number, targets) in (1..).zip(&loaded.shares) {
        let log = fs::read_to_string(job.log(number)).ok();
        let error = log.as_deref().and_then(failure);
        let mut is_done = true;
        for target in targets {
            is_done &= self::is_done(&loaded, *target)?;
        }
        let state = match (&log, error) {
            _ if is_done => State::Done,
            (_, Some(error)) => {
                reasons.push(format!("part {number}: {error}"));
                State::Failed
            }
            (Some(_), None) => State::UnderWay,
            (None, None) => State::Missing,
        };
        parts.push((number, state));
    }
    let are = |state: State| -> Vec<u32> {
        parts.iter().filter(|(_, own)| *own == state).map(|(number, _)| *number).collect()
    };
    let done = are(State::Done).len();
    say!("{done} of {} parts are done", parts.len());
    for (state, words) in
        [(State::Failed, "failed"), (State::UnderWay, "under way, or cut off"), (State::Missing, "not begun")]
    {
        let numbers = are(state);
        if !numbers.is_empty() {
            say!("{words}: {} ({})", numbers.len(), ranges(&numbers));
        }
    }
    for reason in reasons {
        say!("{reason}");
    }
    Ok(ExitCode::SUCCESS)
}

/// Are its files there, or those of the picture that it is a band of?
fn is_done(loaded: &Loaded, target: Target) -> Result<bool, Error> {
    Ok(loaded.is_there(target)? || loaded.is_there(Target { band: None, ..target })?)
}
