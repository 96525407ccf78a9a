//! `bentray farm parallel`: writes a script for GNU parallel, on this machine or on several that share its folder.

use std::path::PathBuf;

use clap::Args;

use super::job::{Job, Written, finish_words, or_say, program, render_words};
use crate::cli::paths;
use crate::cli::words::quoted;
use crate::error::Error;

/// Write a script that runs the parts with GNU parallel and combines them
#[derive(Debug, Args)]
pub(super) struct Parallel {
    /// Number of parts at a time on each machine
    #[arg(long, value_name = "N", default_value = "1")]
    at_once: u32,
    /// File of machines, one per line, as for GNU parallel's --sshloginfile; by default this machine. Each machine needs bentray and the
    /// folder at the same paths
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
    // Parallel's shell parses the command again, and replaces `{}` by the part's number; other braces belong to file names.
    let render = render_words(&program(), &format!("@PART@/{parts}"));
    let command = format!("{{ {}; }} >{folder}/part-@PART@.log 2>&1", or_say(&quoted(&render)));
    let finish = quoted(&finish_words(&program(), parts));
    let script = format!(
        "#!/bin/bash\n# Run this in the folder to which the path of the scene is relative. A second run renders \
         missing parts only.\nset -uo pipefail\nseq {parts} | parallel --jobs {}{hosts} --workdir . -I@PART@ \
         --retries 3 {}\nexec {finish}\n",
        arguments.at_once,
        quoted(&[command]),
    );
    let script = job.write("run.sh", &script)?;
    let command = format!("bash {}", quoted(&[script.display().to_string()]));
    job.format().say(&Written::new(parts, vec![script], vec![command]))
}
