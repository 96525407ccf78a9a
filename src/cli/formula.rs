//! `bentray formula`: plots formulas, without a scene or a device.

use std::path::PathBuf;

use clap::{Args, Subcommand};

use super::paths;
use crate::chart::{beer_chart, fresnel_chart, noise_chart, snell_chart, spiral_chart, spiral_plot, wrapped_chart};
use crate::error::Error;
use crate::output::plot::{plot_lines, plot_paths};

/// Plot a formula, for teaching
#[derive(Debug, Args)]
pub(super) struct Arguments {
    #[command(subcommand)]
    formula: Formula,
}

#[derive(Debug, Args)]
struct Drawing {
    /// Output file, .svg or .png
    #[arg(short, long, value_name = "FILE", value_parser = paths::file())]
    output: PathBuf,
}

#[derive(Debug, Subcommand)]
enum Formula {
    /// Fraction of light that a surface reflects and transmits, against the angle of incidence
    Fresnel {
        /// η, the index behind the surface divided by the index in front of it (several with commas)
        #[arg(long, value_name = "ETA", value_delimiter = ',', default_values_t = [1.4], value_parser = positive)]
        eta: Vec<f64>,
        #[command(flatten)]
        drawing: Drawing,
    },
    /// Angle of refraction at a surface
    Snell {
        /// η, the index behind the surface divided by the index in front of it (several with commas)
        #[arg(long, value_name = "ETA", value_delimiter = ',', default_values_t = [1.33, 1.52, 1.0 / 1.52], value_parser = positive)]
        eta: Vec<f64>,
        #[command(flatten)]
        drawing: Drawing,
    },
    /// Fraction of light that remains after a distance in an absorbing medium
    Beer {
        /// Fraction that remains after a distance of 1 (several with commas)
        #[arg(long, value_name = "C", value_delimiter = ',', default_values_t = [0.95, 0.8, 0.65, 0.45, 0.2], value_parser = part)]
        c: Vec<f64>,
        /// Longest distance
        #[arg(long, value_name = "D", default_value_t = 5.0, value_parser = positive)]
        distance: f64,
        #[command(flatten)]
        drawing: Drawing,
    },
    /// Noise along a line: its octaves and their sum, or the wrapped sum
    Noise {
        /// Number of octaves, each with twice the frequency and half the amplitude of the one before
        #[arg(long, value_name = "N", default_value_t = 4, value_parser = clap::value_parser!(u32).range(1..=8))]
        octaves: u32,
        /// Length of the line, in cells of the first octave
        #[arg(long, value_name = "CELLS", default_value_t = 8.0, value_parser = cells)]
        length: f64,
        /// Seed of the random numbers
        #[arg(long, value_name = "N", default_value_t = 0)]
        seed: u32,
        /// Draw the sum from 0 to 1, and wrapped M times, instead of the octaves
        #[arg(long, value_name = "M", value_parser = positive)]
        wrap: Option<f64>,
        #[command(flatten)]
        drawing: Drawing,
    },
    /// Angle swept by a ray in an inverse-r sphere, against its starting angle
    Spiral {
        /// R/S: radius of the sphere divided by the starting radius
        #[arg(long, value_name = "R/S", default_value_t = std::f64::consts::E, value_parser = beyond_one)]
        ratio: f64,
        #[command(flatten)]
        drawing: Drawing,
    },
    /// Rays in an inverse-r sphere: logarithmic spirals
    Spirals {
        /// Degrees between the ray and the circle through its start: outwards from 0 to 180, inwards above 180 (several with commas)
        #[arg(long, value_name = "DEGREES", value_delimiter = ',', default_values_t = [0.0, 30.0, 90.0, 150.0, 210.0, 270.0, 330.0])]
        #[arg(allow_negative_numbers = true, value_parser = angle)]
        psi: Vec<f64>,
        /// R/S: radius of the sphere divided by the starting radius
        #[arg(long, value_name = "R/S", default_value_t = 2.0, value_parser = beyond_one)]
        ratio: f64,
        #[command(flatten)]
        drawing: Drawing,
    },
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Error> {
    let (chart, drawing) = match &arguments.formula {
        Formula::Fresnel { eta, drawing } => (fresnel_chart(eta), drawing),
        Formula::Snell { eta, drawing } => (snell_chart(eta), drawing),
        Formula::Beer { c, distance, drawing } => (beer_chart(c, *distance), drawing),
        Formula::Noise { octaves, length, seed, wrap: Some(times), drawing } => {
            (wrapped_chart(*octaves, *length, *seed, *times), drawing)
        }
        Formula::Noise { octaves, length, seed, wrap: None, drawing } => {
            (noise_chart(*octaves, *length, *seed), drawing)
        }
        Formula::Spiral { ratio, drawing } => (spiral_chart(*ratio), drawing),
        Formula::Spirals { psi, ratio, drawing } => {
            let names: Vec<String> = psi.iter().map(|psi| format!("{psi}° to the circle")).collect();
            plot_paths(&drawing.output, &spiral_plot(*ratio, psi, &names))?;
            return Ok(());
        }
    };
    Ok(plot_lines(&drawing.output, &chart)?)
}

fn positive(text: &str) -> Result<f64, String> {
    number(text, |n| n > 0.0 && n <= 1e6)
        .ok_or_else(|| format!("expected a number > 0 and at most 1e6, found `{text}`"))
}

fn cells(text: &str) -> Result<f64, String> {
    number(text, |n| n > 0.0 && n <= 1000.0)
        .ok_or_else(|| format!("expected a number > 0 and at most 1000, found `{text}`"))
}

fn part(text: &str) -> Result<f64, String> {
    number(text, |n| n > 0.0 && n <= 1.0).ok_or_else(|| format!("expected a number > 0 and at most 1, found `{text}`"))
}

fn beyond_one(text: &str) -> Result<f64, String> {
    number(text, |n| n > 1.0 && n <= 1e6)
        .ok_or_else(|| format!("expected a number > 1 and at most 1e6, found `{text}`"))
}

/// Parses an angle for which a spiral can be drawn; very close to a circle, it would wind a thousand times.
fn angle(text: &str) -> Result<f64, String> {
    let drawable = |n: f64| (0.0..360.0).contains(&n) && (n % 180.0 == 0.0 || n.to_radians().tan().abs() > 1e-3);
    number(text, drawable).ok_or_else(|| {
        format!(
            "expected an angle from 0 to 360 degrees, either 0, 180 or at least 0.06 away from them, found `{text}`"
        )
    })
}

fn number(text: &str, right: impl Fn(f64) -> bool) -> Option<f64> {
    text.trim().parse().ok().filter(|n| right(*n))
}
