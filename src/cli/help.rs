//! `bentray help`: lists the commands, and prints their options and the pages of the manual.
//!
//! *Idea.* A topic is a command, or a page of the [manual](crate::guide). If one name is both, like `light`, both are printed.

use std::fmt::Write;
use std::process::ExitCode;

use clap::Args;

use crate::document::values::suggest;
use crate::error::Error;
use crate::guide::{Page, pages};

/// The exit code for a usage error, as in clap.
const USAGE: u8 = 2;

/// Print this message, the help of a command, or a page of the manual
#[derive(Debug, Args)]
pub(super) struct Arguments {
    /// A command, such as `render`, or a page of the manual, such as `scenes`
    topic: Vec<String>,
}

/// Returns the list of the manual's pages by part, for display below the commands.
pub(super) fn topics() -> String {
    let mut text = "The manual, for `bentray help PAGE`:".to_owned();
    let mut part = None;
    for page in pages() {
        // Writing to a string cannot fail.
        let _ = if part == Some(page.part) {
            write!(text, ", {}", page.name)
        } else if page.part.is_empty() {
            write!(text, "\n  {}", page.name)
        } else {
            write!(text, "\n  {}: {}", page.part, page.name)
        };
        part = Some(page.part);
    }
    text
}

/// Prints the help of a topic; `cli` is the whole command line.
pub(super) fn run(arguments: &Arguments, cli: &clap::Command) -> Result<ExitCode, Error> {
    let topic = arguments.topic.join(" ");
    let page = pages().find(|page| page.name == topic.replace('-', "_")).map(Page::shown);
    let help = help_of(cli, &arguments.topic);
    let found: Vec<&str> = help.iter().chain(&page).map(|text| text.trim_end()).collect();
    if found.is_empty() {
        let commands = cli.get_subcommands().map(clap::Command::get_name);
        let names: Vec<&str> = commands.chain(pages().map(|page| page.name)).collect();
        tell!("error: unknown command or topic `{topic}`; {}", suggest(&topic, &names, "commands and topics"));
        return Ok(ExitCode::from(USAGE));
    }
    say!("{}", found.join("\n\n"));
    Ok(ExitCode::SUCCESS)
}

/// Returns the output of `--help` after these words, or `None` if they are not a command.
fn help_of(cli: &clap::Command, words: &[String]) -> Option<String> {
    let find = |command: Option<_>, word| command.and_then(|command: &clap::Command| command.find_subcommand(word));
    words.iter().fold(Some(cli), find)?;
    let line = [cli.get_name()].into_iter().chain(words.iter().map(String::as_str)).chain(["--help"]);
    cli.clone().try_get_matches_from(line).err().map(|help| help.to_string())
}
