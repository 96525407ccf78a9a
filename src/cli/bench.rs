//! `bentray bench`: the sources' tables, repeated.

use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Args, ValueEnum};

use super::options::parse_size;
use crate::chart::{ACCELERATED_2004, CRITICAL, PLAIN_2004, PaperBench, Sample, shadow_edge};
use crate::error::Error;
use crate::gpu::Gpu;
use crate::output::plot::{Chart, Series, plot_lines};

/// Measure: the sources' tables, as a table and a plot
#[derive(Debug, Args)]
pub(super) struct Arguments {
    /// Which measurement
    #[arg(value_enum)]
    name: Name,
    /// Draw Figure 5 (time over the number of spheres) as SVG
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// The device whose name contains this
    #[arg(long, value_name = "NAME")]
    device: Option<String>,
    /// Each time is the median of so many
    #[arg(long, default_value_t = 3, value_parser = clap::value_parser!(u32).range(1..=100))]
    repeats: u32,
    /// Another viewport than the paper's, for a trial
    #[arg(long, value_name = "WxH", default_value = "800x600", value_parser = parse_size)]
    size: [u32; 2],
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Name {
    /// The measurements of the 2004 paper: every schedule, Table 1, Figure 5, and its Euler steps' error
    Paper,
}

pub(super) fn run(arguments: &Arguments) -> Result<ExitCode, Error> {
    let Name::Paper = arguments.name;
    let gpu = Gpu::open(arguments.device.as_deref())?;
    let [width, height] = arguments.size;
    say!("{} ({:?}), {width}×{height}, medians of {}", gpu.info.name, gpu.info.device_type, arguments.repeats);
    let bench = PaperBench { gpu: &gpu, repeats: arguments.repeats as usize, size: arguments.size };
    print_schedules(&bench)?;
    print_table(&bench)?;
    print_shadow(&gpu)?;
    print_figure(&bench, arguments.output.as_ref())?;
    Ok(ExitCode::SUCCESS)
}

fn print_schedules(bench: &PaperBench) -> Result<(), Error> {
    say!("\nSchwarzschild, 10 spheres, 300 Euler steps in 30 segments: time of the loop over segments");
    say!("{:<10} {:>12} {:>16} {:>12} {:>16}", "schedule", "no masks", "ns per ray-step", "masks", "ns per ray-step");
    let schedules = bench.schedules()?.0;
    for (name, plain, masked) in &schedules {
        say!(
            "{name:<10} {:>10.3} s {:>16.3} {:>10.3} s {:>16.3}",
            plain.advance.as_secs_f64(),
            plain.ns_per_ray_step(),
            masked.advance.as_secs_f64(),
            masked.ns_per_ray_step()
        );
    }
    if let [(_, paper, paper_masked), .., (_, fused, fused_masked)] = schedules.as_slice() {
        say!(
            "fused is {:.1} times faster than paper, {:.1} times with masks",
            ratio(paper, fused),
            ratio(paper_masked, fused_masked)
        );
    }
    Ok(())
}

fn ratio(slow: &Sample, fast: &Sample) -> f64 {
    slow.advance.as_secs_f64() / fast.advance.as_secs_f64()
}

fn print_table(bench: &PaperBench) -> Result<(), Error> {
    say!(
        "\nTable 1 of the paper (2004: ATI Radeon 9700), seconds: no acceleration; early termination and step doubling"
    );
    say!("{:<16} {:>8} {:>8}   {:>8} {:>8}", "law", "2004", "here", "2004", "here");
    for (i, row) in bench.table()?.iter().enumerate() {
        say!(
            "{:<16} {:>8.2} {:>8.3}   {:>8.2} {:>8.3}",
            row.law,
            PLAIN_2004[i],
            row.plain.advance.as_secs_f64(),
            ACCELERATED_2004[i],
            row.accelerated.advance.as_secs_f64()
        );
    }
    Ok(())
}

fn print_shadow(gpu: &Gpu) -> Result<(), Error> {
    say!("\nThe shadow's edge from r = 50 M (b = {CRITICAL:.3} M):");
    let methods = [
        ("Euler, h = 0.15", "method = \"euler\"\nstep = 0.15"),
        ("Euler, 300 steps through the scene", "method = \"euler\"\nstep = 0.3333333333"),
        (
            "Euler doubling, the paper's rule, 1e-3",
            "method = \"euler-doubling\"\ndoubling = \"paper\"\ntolerance = 1e-3",
        ),
        ("RK4, h = 0.1 r (default)", "method = \"rk4\"\nscaled_step = 0.1"),
    ];
    for (name, keys) in methods {
        match shadow_edge(gpu, keys)? {
            Some(b) => say!("{name:<40} {b:>7.2}  ({:+.1} %)", 100.0 * (b / CRITICAL - 1.0)),
            None => say!("{name:<40} no ray is captured"),
        }
    }
    Ok(())
}

fn print_figure(bench: &PaperBench, output: Option<&PathBuf>) -> Result<(), Error> {
    say!("\nFigure 5 of the paper: 500 steps in 50 segments, seconds");
    say!("{:>8} {:>16} {:>16}", "spheres", "no acceleration", "acceleration");
    let points = bench.figure(&[1, 5, 10, 15, 20])?;
    for (n, plain, accelerated) in &points {
        say!("{n:>8} {:>16.3} {:>16.3}", plain.advance.as_secs_f64(), accelerated.advance.as_secs_f64());
    }
    let Some(path) = output else { return Ok(()) };
    let series = |name: &str, pick: fn(&(usize, Sample, Sample)) -> Sample| Series {
        name: name.to_owned(),
        points: points.iter().map(|point| [point.0 as f64, pick(point).advance.as_secs_f64()]).collect(),
    };
    let chart = Chart {
        title: "500 Euler steps in 50 segments, Schwarzschild (W04, Figure 5)".to_owned(),
        x_label: "spheres".to_owned(),
        y_label: "seconds on the device".to_owned(),
        log_x: false,
        log_y: false,
        series: vec![series("no acceleration", |p| p.1), series("acceleration", |p| p.2)],
    };
    plot_lines(path, &chart)?;
    Ok(())
}
