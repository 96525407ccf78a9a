//! `--json`: results for scripts.
//!
//! *Idea.* A result is one value that is printed as text or as JSON, so that people and scripts get the same information. Scripts get
//! one object per line, as results arrive, and nothing else on standard output; messages and exit codes do not depend on `--json`.
//! The guide's page `scripts` lists the keys, and a test compares it with the output.

use std::path::Path;

use clap::Args;
use serde_json::Value;

use super::say_line;
use crate::error::Error;

/// A result of a command.
pub(super) trait CommandResult {
    /// Returns the lines for people; empty if there is nothing to print.
    fn text(&self) -> String;

    /// Returns the object for scripts. Keys contain their units; a field that does not apply is null.
    fn json(&self) -> Value;
}

/// A result that is printed later.
#[derive(Debug)]
pub(super) struct Deferred {
    text: String,
    json: Value,
}

impl Deferred {
    /// Returns the text and the JSON of a result.
    pub(super) fn of(found: &impl CommandResult) -> Self {
        Self { text: found.text(), json: found.json() }
    }
}

impl CommandResult for Deferred {
    fn text(&self) -> String {
        self.text.clone()
    }

    fn json(&self) -> Value {
        self.json.clone()
    }
}

/// The format of results: text or JSON.
#[derive(Debug, Clone, Copy, Args)]
pub(super) struct Format {
    /// Print results as JSON for scripts, one object per line; `bentray help scripts` lists the keys
    #[arg(long)]
    pub(super) json: bool,
}

impl Format {
    /// Prints a result to standard output.
    pub(super) fn say(self, found: &impl CommandResult) -> Result<(), Error> {
        if self.json {
            say!("{}", found.json());
        } else {
            let text = found.text();
            say!("{}", text.strip_suffix('\n').unwrap_or(&text));
        }
        Ok(())
    }

    /// Prints a result among the messages as text, or to standard output as JSON. If the reader is gone, the command still writes its
    /// other outputs.
    pub(super) fn tell(self, found: &impl CommandResult) -> Result<(), Error> {
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

/// Returns a number with its noun, in the plural unless the number is 1.
pub(super) fn counted((number, noun): (usize, &str)) -> String {
    format!("{number} {noun}{}", if number == 1 { "" } else { "s" })
}

/// Returns a path for JSON; names that are not UTF-8 are shown as well as possible.
pub(super) fn shown(path: impl AsRef<Path>) -> String {
    path.as_ref().display().to_string()
}
