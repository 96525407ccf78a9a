//! The growth of time with pixels, steps, spheres, lights and samples.
//!
//! *Practice.* One number is doubled at a time, with everything else as in the benchmark's scene. The exponent is the slope of a linear fit
//! to the logarithms: 1 means proportional time.

use super::paper::{How, SCHWARZSCHILD, by_fused, scene};
use super::times::{device_time, slope};
use super::{Bench, Report, Table, Times};
use crate::model::control::scaled;
use crate::model::method;
use crate::output::plot::{Chart, Series};
use crate::program::RaySkipping;
use crate::render::{RenderError, Renderer};
use crate::scene::Scene;

const DOUBLINGS: u32 = 5;

/// A function that returns a scene with this size.
type Grow = fn(&Bench, u32) -> Result<Scene, RenderError>;

const GROWN: [(&str, Grow); 5] =
    [("pixels", pixels), ("steps", steps), ("spheres", spheres), ("lights", lights), ("samples", samples)];

/// Measures times and exponents.
///
/// # Errors
///
/// Returns an error if the device fails or cannot run a program of this measurement.
pub fn scaling(bench: &Bench) -> Result<Report, RenderError> {
    let header = "quantity | factor | advance (s) | all (s) | spread";
    let mut times = Table::new("times", "Time of the advance passes and of all passes", header);
    let mut exponents = Table::new("exponents", "Exponent of the growth of time", "quantity | advance | all");
    let mut series = Vec::new();
    for (name, grow) in GROWN {
        let mut points = Vec::new();
        for doubling in 0..DOUBLINGS {
            let factor = 1 << doubling;
            let scene = grow(bench, factor)?;
            let mut renderer = Renderer::new(bench.gpu, &scene, by_fused(RaySkipping::List))?;
            let mut all = 0.0;
            let advance = Times::of(bench.repeats, || {
                let totals = renderer.render()?.totals;
                all = device_time(&totals).as_secs_f64();
                Ok(totals.advance())
            })?;
            times.row(&[name], [factor.into(), advance.median, all, advance.spread]);
            points.push([f64::from(factor), advance.median, all]);
        }
        let slope = |k: usize| exponent(points.iter().map(|point| [point[0], point[k]]));
        exponents.row(&[name], [slope(1), slope(2)]);
        series.push(Series::new(name, points.iter().map(|p| [p[0], p[2]]).collect()));
    }
    let chart = Chart::logarithmic("Growth of time", ["factor", "seconds on the device"], series);
    let intro = vec![
        "RK4 in Schwarzschild spacetime with ten spheres. In each series, only the named quantity is doubled."
            .to_owned(),
    ];
    Ok(Report {
        name: "scaling",
        title: "Scaling".to_owned(),
        intro,
        tables: vec![exponents, times],
        plots: vec![("times", chart)],
    })
}

/// Returns the slope of the linear fit to the points' logarithms.
fn exponent(points: impl Iterator<Item = [f64; 2]>) -> f64 {
    slope(points.map(|point| point.map(f64::ln)))
}

fn base(size: [u32; 2], balls: u32) -> Result<Scene, RenderError> {
    let mut scene = scene(size, SCHWARZSCHILD, balls, 30, How::Ours)?;
    scene.rays.auto = None;
    scene.rays.method = method::PLANNED;
    scene.rays.control = scaled::with(0.2);
    scene.rays.max_segments = 4000;
    Ok(scene)
}

/// Returns a quarter of the benchmark's image, for which the largest size of a series is affordable.
fn part(bench: &Bench) -> [u32; 2] {
    bench.size.map(|side| (side / 4).max(8))
}

fn pixels(bench: &Bench, factor: u32) -> Result<Scene, RenderError> {
    let [width, height] = part(bench);
    base([width * factor, height], 10)
}

fn steps(bench: &Bench, factor: u32) -> Result<Scene, RenderError> {
    let mut scene = base(part(bench), 10)?;
    scene.rays.control = scaled::with(0.2 / f64::from(factor));
    Ok(scene)
}

fn spheres(bench: &Bench, factor: u32) -> Result<Scene, RenderError> {
    base(part(bench), 4 * factor)
}

fn lights(bench: &Bench, factor: u32) -> Result<Scene, RenderError> {
    let mut scene = base(part(bench), 10)?;
    let first = scene.lights.clone();
    scene.lights = first.iter().cycle().take(factor as usize).copied().collect();
    Ok(scene)
}

fn samples(bench: &Bench, factor: u32) -> Result<Scene, RenderError> {
    let mut scene = base(part(bench), 10)?;
    scene.image.samples = factor;
    Ok(scene)
}

#[cfg(test)]
mod tests {
    #[test]
    fn powers_have_their_exponent() {
        let points = [1.0, 2.0, 4.0, 8.0].map(|x: f64| [x, 3.0 * x.powf(0.7)]);
        assert!((super::exponent(points.into_iter()) - 0.7).abs() < 1e-12);
    }
}
