//! The benefit of sampling methods: an image's error against its samples, uniform, with footprints and adaptive.

use super::times::device_time;
use super::{Bench, Cell, Report, Table, Times};
use crate::measure::method_words;
use crate::output::color::display;
use crate::output::plot::{Chart, Series};
use crate::render::{RenderError, RenderSettings, Renderer, Rendering};
use crate::scene::{SamplePattern, Scene};

/// The number of samples of reference images.
const REFERENCE: u32 = 1024;
/// The numbers of samples of uniform images.
const UNIFORM: [u32; 4] = [1, 4, 16, 64];
/// The uniform number of samples that adaptive sampling must match.
const AIM: u32 = 16;
/// The tolerances of adaptive images.
const TOLERANCES: [f64; 4] = [0.02, 0.03, 0.05, 0.08];
/// The tolerance for all scenes, by which adaptive sampling is judged.
const USUAL: f64 = 0.05;
/// The largest number of samples of an adaptive pixel.
const MOST: u32 = 64;
/// The number of samples per pixel that adaptive sampling must not exceed.
const FEW: f64 = 6.0;

/// The sampling of an image.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Sampling {
    Uniform(u32),
    /// Uniform sampling with filtered textures and patterns.
    Footprints(u32),
    Adaptive(f64),
}

impl Sampling {
    fn name(self) -> &'static str {
        match self {
            Self::Uniform(_) => "uniform",
            Self::Footprints(_) => "footprints",
            Self::Adaptive(_) => "adaptive",
        }
    }
}

/// The measurement of a sampling.
struct Measured {
    sampling: Sampling,
    /// The root mean square error over pixels and channels, in unrounded PNG values from 0 to 1.
    rmse: f64,
    /// The average number of samples per pixel.
    samples: f64,
    capped: Option<f64>,
    times: Times,
}

/// Measures every scene, by name, with each sampling.
///
/// # Errors
///
/// Returns an error if the device fails or cannot run a program of this measurement.
pub fn sampling(bench: &Bench, scenes: &[(String, Scene)]) -> Result<Report, RenderError> {
    let header = "scene | method | sampling | tolerance | samples per pixel | RMSE | relative to uniform 16 | at the \
                  cap (%) | device (s) | spread";
    let caption = format!("Error relative to {REFERENCE} samples per pixel; adaptive images take up to {MOST}");
    let mut table = Table::new("scenes", caption, header);
    let caption = format!("Adaptive at {USUAL} in every scene, compared with {AIM} samples per pixel");
    let header = "scene | uniform 16 (RMSE) | adaptive (RMSE) | samples per pixel | as good with at most 6";
    let mut judged = Table::new("judged", caption, header);
    let mut series = Vec::new();
    for (name, scene) in scenes {
        let (words, measured) = measure(bench, scene)?;
        let aim = measured.iter().find(|m| m.sampling == Sampling::Uniform(AIM)).map_or(f64::NAN, |m| m.rmse);
        for m in &measured {
            let tolerance = if let Sampling::Adaptive(tolerance) = m.sampling { Some(tolerance) } else { None };
            let numbers = [m.samples, m.rmse, m.rmse / aim].map(Some);
            let times = [m.capped, Some(m.times.median), Some(m.times.spread)];
            table.row(&[name, &words, m.sampling.name()], [tolerance].into_iter().chain(numbers).chain(times));
        }
        for m in measured.iter().filter(|m| m.sampling == Sampling::Adaptive(USUAL)) {
            let reached = if m.rmse <= aim && m.samples <= FEW { "yes" } else { "no" };
            judged.row(&[name], [aim, m.rmse, m.samples].map(Cell::from).into_iter().chain([reached.into()]));
        }
        series.extend(curves(name, &measured));
    }
    let [width, height] = bench.size;
    let labels = ["samples per pixel", "RMSE of displayed values"];
    Ok(Report {
        name: "sampling",
        title: "Sampling".to_owned(),
        intro: vec![format!(
            "{width}×{height} pixels. The error is the root mean square over pixels and channels of PNG values \
             (sRGB, 0 to 1, not rounded). Samples include the rays through the corners, which pixels share. Pixels \
             at the cap took {MOST} samples, and their mean is not within the tolerance. Adaptive sampling misses a \
             detail, such as a star, between four corners of similar color."
        )],
        tables: vec![judged, table],
        plots: vec![("error", Chart::logarithmic("Sampling error", labels, series))],
    })
}

fn curves(name: &str, measured: &[Measured]) -> impl Iterator<Item = Series> {
    measured.chunk_by(|a, b| a.sampling.name() == b.sampling.name()).map(move |alike| Series {
        name: format!("{name}, {}", alike[0].sampling.name()),
        points: alike.iter().map(|m| [m.samples, m.rmse]).collect(),
    })
}

/// Returns all samplings of a scene, and a description of its method.
fn measure(bench: &Bench, scene: &Scene) -> Result<(String, Vec<Measured>), RenderError> {
    let scene = bench.prepared(sampled(scene, Sampling::Uniform(1)))?;
    let truth = sampled(&scene, Sampling::Uniform(REFERENCE));
    let truth = shown(&scene, &Renderer::new(bench.gpu, &truth, RenderSettings::default())?.render()?);
    let mut measured = Vec::new();
    let footprints = UNIFORM.map(Sampling::Footprints).into_iter();
    let footprints = footprints.filter(|sampling| sampled(&scene, *sampling).has_footprints());
    let all = UNIFORM.map(Sampling::Uniform).into_iter().chain(footprints).chain(TOLERANCES.map(Sampling::Adaptive));
    for sampling in all {
        let scene = sampled(&scene, sampling);
        let mut renderer = Renderer::new(bench.gpu, &scene, RenderSettings::default())?;
        renderer.choose_segments()?;
        let picture = renderer.render()?;
        let off = shown(&scene, &picture).iter().zip(&truth).map(|(a, b)| (a - b).powi(2)).sum::<f64>();
        let adaptive = picture.totals.adaptive;
        measured.push(Measured {
            sampling,
            rmse: (off / truth.len() as f64).sqrt(),
            samples: adaptive.map_or_else(|| rays(&scene), |adaptive| adaptive.mean()),
            capped: adaptive.map(|adaptive| 100.0 * adaptive.capped as f64 / bench.pixels()),
            times: Times::of(bench.repeats, || Ok(device_time(&renderer.render()?.totals)))?,
        });
    }
    Ok((method_words(scene.rays.method, scene.rays.control), measured))
}

/// Returns the number of rays per pixel, including the ray through its corner if there is one.
fn rays(scene: &Scene) -> f64 {
    f64::from(scene.image.samples) + f64::from(u8::from(scene.has_footprints()))
}

fn sampled(scene: &Scene, sampling: Sampling) -> Scene {
    let mut scene = scene.clone();
    let (samples, pattern, adaptive) = match sampling {
        Sampling::Uniform(samples) | Sampling::Footprints(samples) => (samples, SamplePattern::MultiJittered, None),
        Sampling::Adaptive(tolerance) => (MOST, SamplePattern::Progressive, Some(tolerance)),
    };
    scene.image.footprints = matches!(sampling, Sampling::Footprints(_));
    (scene.image.samples, scene.image.sampler, scene.image.adaptive) = (samples, pattern, adaptive);
    scene
}

/// Returns the PNG values of the image.
fn shown(scene: &Scene, picture: &Rendering) -> Vec<f64> {
    let [red, green, blue] = &picture.band.color;
    let colors = red.iter().zip(green).zip(blue).map(|((r, g), b)| [*r, *g, *b]);
    colors.flat_map(|color| display(color, scene.output.exposure.exp2(), scene.output.tonemap)).collect()
}
