//! The `bentray` command: parses the command line, runs one subcommand and prints its error.

use std::process::ExitCode;

use bentray::error::Error;

fn main() -> ExitCode {
    match bentray::cli::run() {
        Ok(code) => code,
        Err(Error::Closed) => ExitCode::SUCCESS,
        Err(error) => {
            bentray::cli::tell_error(&error);
            ExitCode::FAILURE
        }
    }
}
