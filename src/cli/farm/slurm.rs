//! `bentray farm slurm`: writes an array of jobs, and a following job that combines the parts.
//!
//! *Practice.* If a node fails, its part is queued again. The last job runs even if others failed, so that it can report the missing
//! parts.

use std::io::stderr;
use std::path::Path;
use std::process::Command;

use clap::Args;

use super::job::{Job, Written, finish_words, or_say, program, render_words};
use crate::cli::words::quoted;
use crate::error::Error;

/// Write the scripts of a Slurm job array with one job per part, and of a job that combines the parts
#[derive(Debug, Args)]
pub(super) struct Slurm {
    /// Also submit the jobs
    #[arg(long)]
    submit: bool,
    /// Option of sbatch for every part, such as --sbatch=--gres=gpu:1 (repeatable)
    #[arg(long, value_name = "OPTION", allow_hyphen_values = true)]
    sbatch: Vec<String>,
    #[command(flatten)]
    job: Job,
}

pub(super) fn run(arguments: &Slurm) -> Result<(), Error> {
    let job = &arguments.job;
    let (name, parts, folder) = (job.name(), job.parts(), job.folder());
    job.load()?;
    let shown = folder.display();
    let line = |option: &String| format!("#SBATCH {option}\n");
    let more: String = arguments.sbatch.iter().map(line).collect();
    let render = quoted(&render_words(&program(), &format!("auto/{parts}")));
    let part = format!(
        "#!/bin/bash\n#SBATCH --job-name={name}\n#SBATCH --array=1-{parts}\n#SBATCH --requeue\n\
         #SBATCH --open-mode=append\n#SBATCH --output={shown}/part-%a.log\n{more}\n{}\n",
        or_say(&render)
    );
    let finish = quoted(&finish_words(&program(), parts));
    let last = format!(
        "#!/bin/bash\n#SBATCH --job-name={name}-finish\n#SBATCH --output={shown}/finish.log\n\nexec {finish}\n"
    );
    let scripts = [job.write("parts.sh", &part)?, job.write("finish.sh", &last)?];
    let [part, last] = [0, 1].map(|i| quoted(&[scripts[i].display().to_string()]));
    let submit = format!(
        "#!/bin/bash\n# Run this in the folder to which the path of the scene is relative.\nset -euo \
         pipefail\nparts=$(sbatch --parsable {part})\nsbatch --dependency=afterany:\"$parts\" {last}\n"
    );
    let submit = job.write("submit.sh", &submit)?;
    if arguments.submit {
        run_script(&submit)?;
    }
    let command = format!("bash {}", quoted(&[submit.display().to_string()]));
    let commands = if arguments.submit { Vec::new() } else { vec![command] };
    job.format().say(&Written::new(parts, [&scripts[..], &[submit]].concat(), commands))
}

/// Submits the jobs. The output of sbatch is a message, not a result.
fn run_script(submit: &Path) -> Result<(), Error> {
    let failed = |why: String| usage!("{}: {why}", submit.display());
    let status = Command::new("bash").arg(submit).stdout(stderr()).status();
    let status = status.map_err(|error| failed(error.to_string()))?;
    if status.success() { Ok(()) } else { Err(failed("sbatch failed; see its messages above".to_owned())) }
}
