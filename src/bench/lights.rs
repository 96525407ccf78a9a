//! Three methods for light along bent paths: straight shadows under any law, a grid of light directions, and shooting (G95 §6).
//!
//! *Practice.* The scene is a room with a ball, two pillars and a light, under three laws. At scattered positions the grid's direction is
//! compared with the sum of all paths of the shooting method, for each voxel size. Images are compared with shooting in 64 bits if the
//! device supports them, and timed as a whole: creation of the grid, passes, and transfer of the image.

use std::cell::{self, RefCell};
use std::time::{Duration, Instant};

use glam::DVec3;

use super::{Bench, Report, Table, Times, own_scene};
use crate::output::plot::{Chart, Series};
use crate::render::{RenderError, RenderSettings, Renderer, light_grids, light_paths};
use crate::scene::{Light, LightGrid, Precision, Scene, Shadows};

const LAWS: [(&str, &str); 3] = [
    ("a center", "kind = \"sources\"\nsources = [{ position = [1, 1.6, 0], strength = 0.3, capture_radius = 1e-3 }]"),
    (
        "two centers",
        "kind = \"sources\"\nsources = [{ position = [1, 1.6, 0], strength = 0.15, capture_radius = 1e-3 }, \
         { position = [-1, 1.2, -1], strength = 0.1, capture_radius = 1e-3 }]",
    ),
    (
        "a lens",
        "kind = \"medium\"\nindex = { kind = \"expression\", n = \"1 + 0.3*exp(-2*((x+1)^2 + (y-1.8)^2 + (z-0.6)^2))\" }",
    ),
];
const LAMP: DVec3 = DVec3::new(-3.0, 3.6, 2.0);
/// The numbers of voxels along the room's longest side.
const VOXELS: [u32; 4] = [16, 32, 64, 128];
/// The numbers of voxels of subdivided grids.
const REFINED: [u32; 3] = [16, 32, 64];
/// The number of bytes of a mebibyte.
const MEBIBYTE: f64 = 1_048_576.0;

/// The number of positions at which directions are compared.
const PLACES: u32 = 4000;
/// The fraction of the light along a straight line below which a position is in shadow and is not compared.
const FAINT: f64 = 0.01;
/// The fraction of the unshadowed value or of the mean below which a pixel is in shadow; light that winds around a center is fainter.
const LIT: f32 = 0.05;

/// Measures directions by voxel size, and time against error.
///
/// # Errors
///
/// Returns an error if the device fails or cannot run a program of this measurement.
pub fn lights(bench: &Bench) -> Result<Report, RenderError> {
    let header = "law | voxels | mean angle (rad) | relative to the last | weighted by light (rad) | points | build \
                  (s) | MiB | paths";
    let mut angles =
        Table::new("directions", "Directions in the photon grid, compared with the shooting method", header);
    let header = "law | light | time (s) | spread | mean error | correctly lit or shadowed (%) | grid build (s)";
    let mut pictures = Table::new("pictures", "Images, compared with the shooting method", header);
    let mut by_size = Vec::new();
    let mut plots = Vec::new();
    for ((name, law), plot) in LAWS.into_iter().zip(["centre", "centres", "lens"]) {
        let scene = room(bench.size, law)?;
        by_size.push(Series::new(name, directions(bench, name, &scene, &mut angles)?));
        plots.push((plot, errors(bench, name, &scene, &mut pictures)?));
    }
    let labels = ["voxels along the longest side", "mean angle to the shooting method (rad)"];
    let chart = Chart::logarithmic("Directions in a photon grid", labels, by_size);
    plots.insert(0, ("directions", chart));
    let intro = vec![
        "The room is 6 units wide. The reference solution is the shooting method: in 32 bits for directions, and in \
         64 bits for images if the device supports them."
            .to_owned(),
        "The error of an image is its mean difference from the reference, divided by the mean of the reference. A \
         pixel of the reference is lit if it has more than a twentieth of its value without shadows, or of the mean. \
         An image agrees at a lit pixel if it has more than half of the reference value, and at a shadowed pixel if \
         it has less than half of the value without shadows."
            .to_owned(),
    ];
    let title = "Light along curved rays".to_owned();
    Ok(Report { name: "lights", title, intro, tables: vec![angles, pictures], plots })
}

fn room([width, height]: [u32; 2], law: &str) -> Result<Scene, RenderError> {
    let [x, y, z] = LAMP.to_array();
    let text = format!(
        "[image]\nsize = [{width}, {height}]\n[camera]\nposition = [0.5, 3.2, 6]\nlook_at = [0, 0.8, 0]\nfov = 55\n[law]\n{law}\n\
         [rays]\nmethod = \"dormand-prince\"\ntolerance = 1e-5\nbounding_sphere = {{ radius = 12 }}\n\
         [materials.wall]\ndiffuse = [1, 1, 1]\nambient = 0\n\
         [[objects]]\nshape = \"box\"\nmaterial = \"wall\"\ncenter = [0, -0.1, 0]\nsize = [6, 0.2, 6]\n\
         [[objects]]\nshape = \"box\"\nmaterial = \"wall\"\ncenter = [0, 1.4, -2.9]\nsize = [6, 2.8, 0.2]\n\
         [[objects]]\nshape = \"sphere\"\nmaterial = \"wall\"\ncenter = [-0.6, 0.5, 0.2]\nradius = 0.5\n\
         [[objects]]\nshape = \"box\"\nmaterial = \"wall\"\ncenter = [1.6, 0.6, -1.2]\nsize = [0.5, 1.2, 0.5]\n\
         [[objects]]\nshape = \"cylinder\"\nmaterial = \"wall\"\ncenter = [-1.9, 0.8, -1.2]\naxis = [0, 1, 0]\nheight = 1.6\nradius = 0.25\n\
         [[lights]]\nkind = \"point\"\nposition = [{x}, {y}, {z}]\ncolor = [9, 9, 9]\nfalloff = \"inverse-square\"\nshadows = \"photon-grid\"\n"
    );
    own_scene(&text)
}

/// Returns the scene with changed lights.
fn with_light(scene: &Scene, change: impl FnMut(&mut Light)) -> Scene {
    let mut scene = scene.clone();
    scene.lights.iter_mut().take(1).for_each(change);
    scene
}

fn gridded(scene: &Scene, voxels: u32, refine: u32) -> Scene {
    with_light(scene, |light| light.grid = LightGrid { voxels, refine, paths: LightGrid::usual_paths(voxels) })
}

/// Returns scattered positions in the room, from Roberts's R3 sequence.
fn places() -> Vec<DVec3> {
    let at = |i: u32, r: f64| (f64::from(i) * r).fract();
    let place = |i| DVec3::new(at(i, 0.819_172_513_396), at(i, 0.671_043_606_703), at(i, 0.549_700_477_901));
    (0..PLACES).map(|i| place(i) * DVec3::new(5.6, 2.4, 5.2) + DVec3::new(-2.8, 0.15, -2.6)).collect()
}

/// Returns mean angles by the number of voxels along the longest side.
fn directions(bench: &Bench, name: &str, scene: &Scene, table: &mut Table) -> Result<Vec<[f64; 2]>, RenderError> {
    let settings = RenderSettings::default();
    let places = places();
    let pairs: Vec<[DVec3; 2]> = places.iter().map(|x| [*x, LAMP]).collect();
    let (paths, _) = light_paths(bench.gpu, scene, &settings, &pairs)?;
    let truth: Vec<DVec3> = paths
        .iter()
        .map(|paths| {
            let clear = paths.iter().filter(|path| path.clear && path.spread > 0.0);
            clear.map(|path| DVec3::from(path.arrives) / path.spread).sum()
        })
        .collect();
    let mut points: Vec<[f64; 2]> = Vec::new();
    for voxels in VOXELS {
        let (field, report) = light_grids(bench.gpu, &gridded(scene, voxels, 1), &settings)?.remove(0);
        let lit = places.iter().zip(&truth).filter_map(|(x, truth)| {
            let found = field.at(*x).unwrap_or_default().truncate().as_dvec3();
            let lit = truth.length() > FAINT / x.distance_squared(LAMP);
            (lit && found.length() > 0.0).then(|| (found.angle_between(*truth), truth.length()))
        });
        let angles: Vec<(f64, f64)> = lit.collect();
        let mean = angles.iter().map(|(angle, _)| angle).sum::<f64>() / angles.len().max(1) as f64;
        let light: f64 = angles.iter().map(|(_, light)| light).sum();
        let by_light = angles.iter().map(|(angle, light)| angle * light).sum::<f64>() / light;
        let over = points.last().map(|[_, last]| mean / last);
        let (count, made, mebibytes) = (angles.len() as f64, report.wall.as_secs_f64(), report.bytes as f64 / MEBIBYTE);
        let numbers = [by_light, count, made, mebibytes, report.totals.rays as f64].map(Some);
        table.row(&[name], [Some(f64::from(voxels)), Some(mean), over].into_iter().chain(numbers));
        points.push([f64::from(voxels), mean]);
    }
    Ok(points)
}

/// Returns one color of an image, its total time, and the time of its grid.
fn picture(bench: &Bench, scene: &Scene) -> Result<(Vec<f32>, f64), RenderError> {
    let mut renderer = Renderer::new(bench.gpu, scene, RenderSettings::default())?;
    let grid = renderer.light_reports().iter().map(|report| report.wall.as_secs_f64()).sum();
    let [red, ..] = renderer.render()?.band.color;
    Ok((red, grid))
}

/// A lighting method, with the last result.
struct Way {
    name: String,
    scene: Scene,
    picture: RefCell<Vec<f32>>,
    /// The time of its grid in seconds.
    grid: cell::Cell<f64>,
}

impl Way {
    fn new(name: String, scene: Scene) -> Self {
        Self { name, scene, picture: RefCell::default(), grid: cell::Cell::default() }
    }
}

/// Measures time and error of each method, and returns a chart.
fn errors(bench: &Bench, name: &str, scene: &Scene, table: &mut Table) -> Result<Chart, RenderError> {
    let shadows = |shadows| with_light(scene, |light| light.shadows = shadows);
    let mut exact = shadows(Shadows::Shooting);
    if bench.gpu.f64 {
        exact.rays.precision = Precision::Double;
    }
    let truth = picture(bench, &exact)?.0;
    let open = picture(bench, &shadows(Shadows::None))?.0;
    let mut ways = vec![
        Way::new("straight".to_owned(), shadows(Shadows::Straight)),
        Way::new("shooting".to_owned(), shadows(Shadows::Shooting)),
    ];
    ways.extend(VOXELS.map(|voxels| Way::new(format!("photon grid {voxels}"), gridded(scene, voxels, 1))));
    let refine = LightGrid::default().refine;
    ways.extend(
        REFINED.map(|voxels| Way::new(format!("photon photon grid {voxels}, refined"), gridded(scene, voxels, refine))),
    );
    let run = |way: &Way| -> Result<Duration, RenderError> {
        let started = Instant::now();
        let (picture, grid) = picture(bench, &way.scene)?;
        way.picture.replace(picture);
        way.grid.set(grid);
        Ok(started.elapsed())
    };
    let mut runs: Vec<_> = ways.iter().map(|way| move || run(way)).collect();
    let times = Times::all_by_turns(bench.repeats, &mut runs)?;
    let mut series: Vec<Series> = Vec::new();
    for (way, times) in ways.iter().zip(times) {
        let compared = Compared::new(&way.picture.borrow(), &truth, &open);
        let grid = Some(way.grid.get()).filter(|seconds| *seconds > 0.0);
        let numbers = [times.median, times.spread, compared.error, 100.0 * compared.agree].map(Some);
        table.row(&[name, &way.name], numbers.into_iter().chain([grid]));
        // All sizes of a grid share one line.
        let kind = way.name.replace(|c: char| c.is_ascii_digit(), "").replace(" ,", ",").trim_end().to_owned();
        Series::extend(&mut series, &kind, [times.median, compared.error]);
    }
    Ok(Chart::logarithmic(format!("Light around {name}"), ["time (s)", "mean error"], series))
}

/// The difference of an image from the reference.
struct Compared {
    error: f64,
    /// The fraction of the pixels facing the light on some path whose lit or shadowed state agrees with the reference.
    agree: f64,
}

impl Compared {
    /// Compares two images; `open` is the image without shadows.
    fn new(found: &[f32], truth: &[f32], open: &[f32]) -> Self {
        let sum = |values: &mut dyn Iterator<Item = f64>| values.sum::<f64>();
        let off = sum(&mut found.iter().zip(truth).map(|(a, b)| f64::from((a - b).abs())));
        let all = sum(&mut truth.iter().map(|b| f64::from(*b)));
        let shown = truth.iter().zip(open).filter(|(truth, open)| **truth > 0.0 || **open > 0.0).count().max(1);
        let mean = (all / shown as f64) as f32;
        let (mut agree, mut faces) = (0_u32, 0_u32);
        for ((found, truth), open) in found.iter().zip(truth).zip(open) {
            if *truth > 0.0 || *open > 0.0 {
                let bright = open.max(mean);
                let is_lit = *truth > LIT * bright;
                faces += 1;
                agree += u32::from((*found > 0.5 * if is_lit { *truth } else { bright }) == is_lit);
            }
        }
        Self { error: off / all, agree: f64::from(agree) / f64::from(faces.max(1)) }
    }
}
