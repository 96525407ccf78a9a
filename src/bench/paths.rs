//! The benefit of next-event estimation and path guiding: the time of path tracing for an equal error, in a box with lights of four sizes.
//!
//! *Practice.* The error of random samples falls with the root of their number, so that time × error² does not depend on it; smaller is
//! better. Times are the total wait: compilation, tracing of the guide's light, passes, and transfer of the image. The reference has many
//! more samples with all methods; its noise is in a separate table.

use std::cell::RefCell;
use std::time::{Duration, Instant};

use super::times::device_time;
use super::{Bench, Cell, Report, Table, Times, own_scene};
use crate::output::plot::{Chart, Series};
use crate::render::{Noise, RenderError, RenderSettings, Renderer, Rendering};
use crate::scene::{PathTracing, Scene};

/// The radii of the light, in a box of width 2. All emit equal power.
const LAMPS: [f64; 4] = [0.4, 0.15, 0.05, 0.02];
/// The number of samples of the compared images, followed by that of the reference.
const SAMPLES: u32 = 256;
const TRUTH: u32 = 4096;
/// The fraction of the largest values that errors ignore. The reference also has fireflies of light through glass onto a wall that is
/// visible in the mirror, and smaller lights cause more of them.
const WORST: f64 = 0.01;
/// The methods to find light: next-event estimation, and path guiding.
const WAYS: [(&str, bool, bool); 3] = [
    ("scattered rays", false, false),
    ("direct-light sampling", true, false),
    ("direct-light sampling and guiding", true, true),
];

/// Measures the time for an equal error by the light's size.
///
/// # Errors
///
/// Returns an error if the device fails or cannot run a program of this measurement.
pub fn paths(bench: &Bench) -> Result<Report, RenderError> {
    let header = "emitter radius | sampling | time (s) | spread | error | time × error² | relative to scattered rays \
                  | ns per segment";
    let caption = format!("{SAMPLES} samples per pixel, compared with {TRUTH}");
    let mut table = Table::new("emitters", caption, header);
    let mut truths = Table::new("truths", "Reference images", "emitter radius | noise of the reference");
    let mut series: Vec<Series> = Vec::new();
    for radius in LAMPS {
        let scene = room(bench.size, radius)?;
        let truth = picture(bench, &sampled(&scene, TRUTH, true, true))?.0;
        truths.row(&[], [Some(radius), truth.totals.noise.as_ref().and_then(Noise::mean)]);
        let mut plain = None;
        for found in measure(bench, &scene, &truth)? {
            let cost = found.times.median * found.error * found.error;
            let ratio = cost / *plain.get_or_insert(cost);
            let numbers = [found.times.median, found.times.spread, found.error, cost, ratio, found.segment];
            table.rows.push([radius.into(), found.name.into()].into_iter().chain(numbers.map(Cell::from)).collect());
            Series::extend(&mut series, found.name, [radius, cost]);
        }
    }
    let [width, height] = bench.size;
    let labels = ["radius of the emitter, in a box of width 2", "time × error² (s)"];
    let chart = Chart::logarithmic("Paths to an emitter", labels, series);
    Ok(Report {
        name: "paths",
        title: "Path tracing".to_owned(),
        intro: vec![format!(
            "{width}×{height} pixels. A box with a mirror and a glass sphere, lit by one spherical emitter of \
             constant power and varying radius. The error is the root mean square difference over pixels and \
             channels, divided by the mean of the image, without the worst 1 % of the values. It therefore omits \
             light that a sampling method finds too rarely, such as light from a small emitter through glass without \
             path guiding. Times are wall-clock times; the time of a segment is device time."
        )],
        tables: vec![table, truths],
        plots: vec![("cost", chart)],
    })
}

/// Returns the scene with this number of samples and these methods to find light.
fn sampled(scene: &Scene, samples: u32, aim: bool, guide: bool) -> Scene {
    let mut scene = scene.clone();
    scene.image.samples = samples;
    scene.rays.path_tracing =
        Some(PathTracing { light_sampling: aim, guiding: guide, ..scene.rays.path_tracing.unwrap_or_default() });
    scene
}

/// Renders an image, and returns its total time.
fn picture(bench: &Bench, scene: &Scene) -> Result<(Rendering, Duration), RenderError> {
    let started = Instant::now();
    let mut renderer = Renderer::new(bench.gpu, scene, RenderSettings::default())?;
    renderer.choose_segments()?;
    let picture = renderer.render()?;
    Ok((picture, started.elapsed()))
}

/// The result of one method.
struct MethodResult {
    name: &'static str,
    times: Times,
    /// The error relative to the image's mean.
    error: f64,
    /// The time per segment in nanoseconds.
    segment: f64,
}

fn measure(bench: &Bench, scene: &Scene, truth: &Rendering) -> Result<Vec<MethodResult>, RenderError> {
    let scenes = WAYS.map(|(_, aim, guide)| sampled(scene, SAMPLES, aim, guide));
    let last: Vec<RefCell<Option<Rendering>>> = WAYS.iter().map(|_| RefCell::default()).collect();
    let mut runs: Vec<_> = scenes
        .iter()
        .zip(&last)
        .map(|(scene, last)| {
            move || {
                let (picture, time) = picture(bench, scene)?;
                last.replace(Some(picture));
                Ok(time)
            }
        })
        .collect();
    let times = Times::all_by_turns(bench.repeats, &mut runs)?;
    let pictures = last.iter().map(RefCell::take);
    let found = WAYS.iter().zip(times).zip(pictures).filter_map(|(((name, ..), times), picture)| {
        let picture = picture?;
        let segment = 1e9 * device_time(&picture.totals).as_secs_f64() / picture.totals.segments as f64;
        Some(MethodResult { name, times, error: error(&picture, truth), segment })
    });
    Ok(found.collect())
}

/// Returns the root mean square difference relative to the reference's mean, without the largest fraction `WORST` of values.
fn error(picture: &Rendering, truth: &Rendering) -> f64 {
    let both = || picture.band.color.iter().flatten().zip(truth.band.color.iter().flatten());
    let mut squares: Vec<f64> = both().map(|(a, b)| f64::from(a - b).powi(2)).collect();
    let mean = both().map(|(_, b)| f64::from(*b)).sum::<f64>() / squares.len().max(1) as f64;
    squares.sort_by(f64::total_cmp);
    squares.truncate((squares.len() as f64 * (1.0 - WORST)) as usize);
    (squares.iter().sum::<f64>() / squares.len().max(1) as f64).sqrt() / mean
}

/// Returns a box of matte walls of width 2, open to the camera, with a light of this radius.
fn room([width, height]: [u32; 2], radius: f64) -> Result<Scene, RenderError> {
    // The power equals that of a light of radius 0.3 with a radiance of 8.
    let radiance = 8.0 * (0.3 / radius).powi(2);
    let wall = |material: &str, center: [f64; 3], size: [f64; 3]| {
        format!("[[objects]]\nshape = \"box\"\nmaterial = \"{material}\"\ncenter = {center:?}\nsize = {size:?}\n")
    };
    let walls = [
        wall("white", [0.0, -0.05, 0.0], [2.0, 0.1, 2.0]),
        wall("white", [0.0, 2.05, 0.0], [2.0, 0.1, 2.0]),
        wall("white", [0.0, 1.0, -1.05], [2.0, 2.0, 0.1]),
        wall("red", [-1.05, 1.0, 0.0], [0.1, 2.0, 2.0]),
        wall("green", [1.05, 1.0, 0.0], [0.1, 2.0, 2.0]),
    ];
    let text = format!(
        "[image]\nsize = [{width}, {height}]\n[camera]\nposition = [0, 1, 3.4]\nlook_at = [0, 1, 0]\nfov = 40\n\
         [rays]\nbounding_sphere = {{ center = [0, 1, 0], radius = 5 }}\nlighting = \"path-tracing\"\n\
         [materials.white]\ndiffuse = [0.75, 0.75, 0.75]\n[materials.red]\ndiffuse = [0.65, 0.06, 0.05]\n\
         [materials.green]\ndiffuse = [0.12, 0.5, 0.1]\n[materials.mirror]\nkind = \"mirror\"\ncolor = [0.9, 0.9, 0.9]\n\
         [materials.light]\nkind = \"emissive\"\ncolor = [{radiance}, {radiance}, {radiance}]\n{}\
         [[objects]]\nshape = \"sphere\"\nmaterial = \"mirror\"\ncenter = [-0.45, 0.401, -0.4]\nradius = 0.4\n\
         [[objects]]\nshape = \"sphere\"\ninterior = 1.5\ncenter = [0.45, 0.401, 0.25]\nradius = 0.4\n\
         [[objects]]\nshape = \"sphere\"\nmaterial = \"light\"\ncenter = [0, 1.55, 0]\nradius = {radius}\n",
        walls.concat()
    );
    own_scene(&text)
}
