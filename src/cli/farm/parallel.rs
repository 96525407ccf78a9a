//! `bentray farm parallel`: GNU parallel on this machine, or on a few that share its folder.

use std::path::PathBuf;

use clap::Args;

use super::job::{Job, Written, finish_words, or_say, program, render_words};
use crate::cli::paths;
use crate::cli::words::quoted;
use crate::error::Error;

/// Write a script that runs the parts by GNU parallel, and puts them together
#[derive(Debug, Args)]
pub(super) struct Parallel {
    /// Parts at once on each machine
    #[arg(long, value_name = "N", default_value = "1")]
    at_once: u32,
    /// A file of machines, one a line, as GNU parallel's --sshloginfile takes it; without it this machine. Each has bentray and the
    /// folder in the same place
    #[arg(long, value_name = "FILE", value_parser = paths::file())]
    hosts: Option<PathBuf>,
    #[command(flatten)]
    job: Job,
}

pub(super) fn run(arguments: &Parallel) -> Result<(), Error> {
    let job = &arguments.job;
    let parts = job.parts();
    job.load()?;
    let folder = quoted(&[job.folder().display().to_string()]);
    let hosts = arguments.hosts.as_ref().map(|hosts| quoted(&[hosts.display().to_string()]));
    let hosts = hosts.map(|hosts| format!(" --sshloginfile {hosts}")).unwrap_or_default();
    // Parallel's own shell reads the command once more, and has the part's number for `{}`; other braces are of file names.
    let render = render_words(&program(), &format!("@PART@/{parts}"));
    let command = format!("{{ {}; }} >{folder}/part-@PART@.log 2>&1", or_say(&quoted(&render)));
    let finish = quoted(&finish_words(&program(), parts));
    let script = format!(
        "#!/bin/bash\n# From the folder that the scene's path counts from. Run again, it renders what is missing.\n\
         set -uo pipefail\nseq {parts} | parallel --jobs {}{hosts} --workdir . -I@PART@ --retries 3 {}\nexec {finish}\n",
        arguments.at_once,
        quoted(&[command]),
    );
    let script = job.write("run.sh", &script)?;
    let command = format!("bash {}", quoted(&[script.display().to_string()]));
    job.format().say(&Written::new(parts, vec![script], vec![command]))
}
