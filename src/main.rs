//! The `bentray` command: parses its line, runs one subcommand, prints what went wrong.

use std::process::ExitCode;

fn main() -> ExitCode {
    match bentray::cli::run() {
        Ok(code) => code,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}
