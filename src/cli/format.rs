//! `--json`: results for scripts.
//!
//! *Idea.* A result is one value that can be put into words and into JSON, so that people and scripts are told the same. Scripts get an
//! object a line, as results come, and nothing else on standard output; messages and exit codes are what they are without `--json`.
//! The guide's page `scripts` lists the keys, and a test compares it with what is printed.

use std::path::Path;

use clap::Args;
use serde_json::Value;

use super::say_line;
use crate::error::Error;

/// What a command has found.
pub(super) trait Found {
    /// Lines for people; empty where there is nothing to say to them.
    fn text(&self) -> String;

    /// An object for scripts. Units are in the names of its keys; what does not apply is null.
    fn json(&self) -> Value;
}

/// Whom results are for.
#[derive(Debug, Clone, Copy, Args)]
pub(super) struct Format {
    /// Print results as JSON, for scripts: an object a line, whose keys `bentray help scripts` lists
    #[arg(long)]
    pub(super) json: bool,
}

impl Format {
    /// Prints a result to standard output.
    pub(super) fn say(self, found: &impl Found) -> Result<(), Error> {
        if self.json {
            say!("{}", found.json());
        } else {
            let text = found.text();
            say!("{}", text.strip_suffix('\n').unwrap_or(&text));
        }
        Ok(())
    }

    /// Has people read a result among the messages, and gives it to scripts. Whoever stopped reading wants what else is made all the
    /// same.
    pub(super) fn tell(self, found: &impl Found) -> Result<(), Error> {
        let text = found.text();
        if !text.is_empty() {
            tell!("{text}");
        }
        if !self.json {
            return Ok(());
        }
        match say_line(format_args!("{}", found.json())) {
            Err(Error::Closed) => Ok(()),
            other => other,
        }
    }
}

/// A path as JSON has it: names that are no text are shown as well as can be.
pub(super) fn shown(path: impl AsRef<Path>) -> String {
    path.as_ref().display().to_string()
}
