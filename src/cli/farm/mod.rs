//! `bentray farm`: renders an animation or an image on many machines, in equal parts.
//!
//! *Idea.* There is no custom scheduler: a part is `bentray render --part`, which any job queue can run, and a queue also needs a
//! script. Each queue has a file here that writes it. Parts share only the output folder. An interrupted part leaves no files behind;
//! if it is run again, it renders only the missing files.

mod finish;
mod job;
mod kubernetes;
mod parallel;
mod slurm;
mod status;

use clap::{Args, Subcommand};

use crate::error::Error;
use job::Job;

/// Render an animation or an image on many machines, in equal parts
#[derive(Debug, Args)]
#[command(
    subcommand_required = true,
    after_help = "All subcommands take the arguments of `render`: give each the same arguments and the same number \
                  of --parts."
)]
pub(super) struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    Slurm(slurm::Slurm),
    Kubernetes(kubernetes::Kubernetes),
    Parallel(parallel::Parallel),
    /// Print which parts are done, failed, running and missing
    Status {
        #[command(flatten)]
        job: Job,
    },
    /// Combine the parts, and check that none is missing and that all are from one render
    Finish {
        #[command(flatten)]
        job: Job,
    },
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Error> {
    match &arguments.command {
        Command::Slurm(arguments) => slurm::run(arguments),
        Command::Kubernetes(arguments) => kubernetes::run(arguments),
        Command::Parallel(arguments) => parallel::run(arguments),
        Command::Status { job } => status::run(job),
        Command::Finish { job } => finish::run(job),
    }
}
