//! `bentray completions` and `bentray man`: print shell completions and manual pages.

use clap::{Args, Command};
use clap_complete::Shell;

use super::say_line;
use crate::error::Error;
use crate::output::OutputError;

/// Print a shell completion script
#[derive(Debug, Args)]
#[command(after_help = "For bash: bentray completions bash > ~/.local/share/bash-completion/completions/bentray")]
pub(super) struct Completions {
    /// The shell
    shell: Shell,
}

/// Print the manual page of bentray, or of one command
#[derive(Debug, Args)]
#[command(after_help = "For example: bentray man render | man -l -")]
pub(super) struct Man {
    /// The command, such as `render`
    command: Option<String>,
}

pub(super) fn complete(arguments: &Completions, mut cli: Command) -> Result<(), Error> {
    let mut text = Vec::new();
    let name = cli.get_name().to_owned();
    clap_complete::generate(arguments.shell, &mut cli, name, &mut text);
    print(&text)
}

pub(super) fn man(arguments: &Man, cli: &Command) -> Result<(), Error> {
    let page = match &arguments.command {
        None => clap_mangen::Man::new(cli.clone()),
        Some(name) => {
            let found = cli.find_subcommand(name).cloned();
            let unknown = || usage!("unknown command `{name}`: run `bentray help` for a list");
            let full = format!("{} {name}", cli.get_name());
            clap_mangen::Man::new(found.ok_or_else(unknown)?.bin_name(full.clone())).title(full.replace(' ', "-"))
        }
    };
    let mut text = Vec::new();
    page.render(&mut text).map_err(|cause| OutputError::Write { path: "-".into(), cause })?;
    print(&text)
}

fn print(text: &[u8]) -> Result<(), Error> {
    say_line(format_args!("{}", String::from_utf8_lossy(text).trim_end()))
}
