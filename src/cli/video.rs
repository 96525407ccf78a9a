//! `bentray video`: encodes images as a video.

use std::path::PathBuf;

use clap::Args;

use super::{paths, screen};
use crate::error::Error;
use crate::output::{film, lost_alpha};

/// Encode images as a video, in the given order; `render --frames all -o film.mp4` renders and encodes in one step
#[derive(Debug, Args)]
pub(super) struct Arguments {
    /// The images, all of equal size
    #[arg(required = true, value_name = "PICTURE", value_parser = paths::file())]
    frames: Vec<PathBuf>,
    /// Output file: .mp4 or .webm (encoded with ffmpeg), .gif, or .png (animated PNG) (repeatable)
    #[arg(short, long, required = true, value_name = "FILE", value_parser = paths::file())]
    output: Vec<PathBuf>,
    /// Frames per second
    #[arg(long, value_name = "N", default_value = "24", value_parser = parse_rate)]
    rate: f64,
}

fn parse_rate(text: &str) -> Result<f64, String> {
    let rate = text.parse().ok().filter(|rate| (0.1..=1000.0).contains(rate));
    rate.ok_or_else(|| format!("expected a number of frames per second from 0.1 to 1000, found `{text}`"))
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Error> {
    let frames: Vec<_> = arguments.frames.iter().map(|path| (path.clone(), "one of the frames")).collect();
    paths::check(arguments.output.iter().map(PathBuf::as_path), &frames)?;
    for path in &arguments.output {
        film(path, &arguments.frames, arguments.rate, &screen::progress())?;
        if let Some(words) = lost_alpha(path, &arguments.frames) {
            tell!("warning: {} cannot store all alpha values: {words} (an animated .png keeps alpha)", path.display());
        }
    }
    Ok(())
}
