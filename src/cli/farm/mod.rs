//! `bentray farm`: a film or a picture on many machines, in equal parts.
//!
//! *Idea.* No scheduler of our own: a part is `bentray render --part`, which any queue of jobs can run, and what a queue needs besides is a
//! script. Each queue has a file here that writes it. Parts share nothing but the folder that they write to; a part that was cut off leaves
//! nothing behind, and run again it renders only what is missing.

mod finish;
mod job;
mod kubernetes;
mod parallel;
mod slurm;
mod status;

use clap::{Args, Subcommand};

use crate::error::Error;
use job::Job;

/// Render a film or a picture on many machines, in equal parts
#[derive(Debug, Args)]
#[command(
    subcommand_required = true,
    after_help = "All take what `render` takes: type the same behind each, with the same number of --parts."
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
    /// Say which parts are done, failed, under way and missing
    Status {
        #[command(flatten)]
        job: Job,
    },
    /// Put the parts together, and check that none is missing and all are of the same render
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
