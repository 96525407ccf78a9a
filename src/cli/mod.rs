//! The command line, with one file per subcommand.
//!
//! Results go to stdout or to the named files; messages and progress go to stderr. Exit codes: 0 for success, 1 for failure,
//! 2 for a usage error. A result that scripts may read is a `Report` of `format`, which prints it as text or as JSON.

/// Prints a line of results to standard output, in functions that return this crate's error.
macro_rules! say {
    ($($format:tt)*) => {
        $crate::cli::say_line(format_args!($($format)*))?
    };
}

/// Prints a line of messages to standard error. If the reader is gone, only the message is lost.
macro_rules! tell {
    ($($format:tt)*) => {
        $crate::cli::tell_line(format_args!($($format)*))
    };
}

/// Creates the error for arguments that only a scene or a file shows to be wrong.
macro_rules! usage {
    ($($format:tt)*) => {
        $crate::error::Error::Usage(format!($($format)*))
    };
}

mod bench;
mod check;
mod choose_method;
mod compare;
mod continuation;
mod decisions;
mod devices;
mod doctor;
mod earlier_map;
mod farm;
mod format;
mod formula;
mod frame_list;
mod frame_names;
mod frames;
mod help;
mod import;
mod interrupt;
mod light;
mod map;
mod merge;
mod new;
mod options;
mod origin;
mod paths;
mod profile;
mod queue;
mod render;
mod screen;
mod share;
mod shell;
mod trace;
mod video;
mod watch;
mod wgsl;
mod words;
mod written;

use std::fmt::{Arguments, Display};
use std::io::{self, ErrorKind};
use std::path::Path;
use std::process::ExitCode;

use clap::error::ContextKind;
use clap::{CommandFactory, Parser, Subcommand};

use crate::document::given_name;
use crate::error::Error;
use crate::output::has_extension;

/// A renderer for light that does not travel straight.
#[derive(Debug, Parser)]
#[command(name = "bentray", version, about, max_term_width = 100)]
#[command(disable_help_subcommand = true, after_help = help::topics())]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    Render(render::Arguments),
    Map(map::Arguments),
    Merge(merge::Arguments),
    Farm(farm::Arguments),
    Video(video::Arguments),
    Check(check::Arguments),
    Trace(trace::Arguments),
    Light(light::Arguments),
    Profile(profile::Arguments),
    Devices(devices::Arguments),
    Doctor(doctor::Arguments),
    Wgsl(wgsl::Arguments),
    Compare(compare::Arguments),
    Bench(bench::Arguments),
    Formula(formula::Arguments),
    New(new::Arguments),
    Import(import::Arguments),
    Completions(shell::Completions),
    Man(shell::Man),
    Help(help::Arguments),
}

/// Runs the command given by the arguments of the process.
///
/// # Errors
///
/// Returns the error of the command, which the caller prints; [`Error::Closed`] if the reader of standard output closed it. Usage errors
/// are printed here.
pub fn run() -> Result<ExitCode, Error> {
    let command = match Cli::try_parse() {
        Ok(cli) => cli.command,
        Err(error) => return Ok(refuse(&error)),
    };
    interrupt::listen();
    let _drawing = screen::Drawing::begin();
    let done = match command {
        Command::Render(arguments) => return render::run(&arguments),
        Command::Check(arguments) => return check::run(&arguments),
        Command::Doctor(arguments) => return doctor::run(&arguments),
        Command::Compare(arguments) => return compare::run(&arguments),
        Command::Help(arguments) => return help::run(&arguments, &Cli::command()),
        Command::Map(arguments) => map::run(&arguments),
        Command::Merge(arguments) => merge::run(&arguments),
        Command::Farm(arguments) => farm::run(&arguments),
        Command::Video(arguments) => video::run(&arguments),
        Command::Trace(arguments) => trace::run(&arguments),
        Command::Light(arguments) => light::run(&arguments),
        Command::Profile(arguments) => profile::run(&arguments),
        Command::Devices(arguments) => devices::run(&arguments),
        Command::Wgsl(arguments) => wgsl::run(&arguments),
        Command::Bench(arguments) => bench::run(&arguments),
        Command::Formula(arguments) => formula::run(&arguments),
        Command::New(arguments) => new::run(&arguments),
        Command::Import(arguments) => import::run(&arguments),
        Command::Completions(arguments) => shell::complete(&arguments, Cli::command()),
        Command::Man(arguments) => shell::man(&arguments, &Cli::command()),
    };
    done.map(|()| ExitCode::SUCCESS)
}

/// The words that users try for a command, an option or a layer, each with its real name.
const RENAMED: &[(&[&str], &str)] = &[
    (&["film", "movie", "encode", "ffmpeg"], "bentray video"),
    (&["assemble", "join", "stitch"], "bentray merge"),
    (&["chart", "accuracy", "convergence"], "bentray compare"),
    (&["validate", "lint"], "bentray check"),
    (&["init", "create", "template"], "bentray new"),
    (&["convert"], "bentray import"),
    (&["benchmark"], "bentray bench"),
    (&["gpus", "adapters", "info"], "bentray devices"),
    (&["spectrum", "lightcurve", "light-curve", "line", "flux"], "bentray profile"),
    (&["geodesic", "raytrace", "rays"], "bentray trace"),
    (&["--no-list"], "--no-compaction"),
    (&["--no-masks"], "--no-early-termination"),
    (&["--method-of"], "--method-from"),
    (&["--frame", "--range", "--limits"], "--view"),
    (&["--spp", "-s"], "--samples"),
    (&["--resolution", "--width", "--height", "-r"], "--size"),
    (&["--out", "--file"], "--output"),
    (&["--gpu", "--adapter"], "--device"),
    (&["shift", "doppler", "g"], "--layers redshift"),
    (&["orders", "rings"], "--layers image_order"),
    (&["sums"], "--layers accumulated"),
    (&["spread", "variance", "m2"], "--layers luminance_m2"),
    (&["error", "stderr", "noise"], "--layers standard_error"),
    (&["z", "distance"], "--layers depth"),
    (&["id", "index", "cryptomatte"], "--layers object"),
];

/// Prints the help if it was requested, otherwise the usage error; if a scene replaces the command, suggests `render`.
fn refuse(error: &clap::Error) -> ExitCode {
    // If stderr is closed, nobody can be told.
    let _ = error.print();
    let unknown = [ContextKind::InvalidArg, ContextKind::InvalidSubcommand, ContextKind::InvalidValue]
        .map(|kind| error.get(kind));
    for word in unknown.into_iter().flatten() {
        if let Some((_, right)) = RENAMED.iter().find(|(words, _)| words.contains(&word.to_string().as_str())) {
            tell!("use `{right}`");
        }
    }
    let scene = std::env::args().nth(1).filter(|name| has_extension(name.as_ref(), "toml"));
    if let (clap::error::ErrorKind::InvalidSubcommand, Some(scene)) = (error.kind(), scene) {
        tell!("to render a scene: bentray render {scene} -o picture.png");
    }
    ExitCode::from(error.exit_code() as u8)
}

/// Prints the reason why a command failed, if stderr is still open.
pub fn tell_error(error: &Error) {
    tell!("error: {error}");
}

/// Returns the error that a command cannot use this scene, which may be valid otherwise.
fn of_scene(path: &Path, problem: impl Display) -> Error {
    usage!("{}: {problem}", given_name(path).display())
}

fn tell_line(line: Arguments) {
    // If stderr is closed, nobody can be told.
    let _ = screen::print_above(&mut io::stderr(), line);
}

fn say_line(line: Arguments) -> Result<(), Error> {
    screen::print_above(&mut io::stdout(), line).map_err(|error| match error.kind() {
        ErrorKind::BrokenPipe => Error::Closed,
        _ => Error::Stdout(error),
    })
}
