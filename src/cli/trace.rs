//! `bentray trace`: follows given rays to their ends.

mod beams;
mod diagram;
mod pairs;

use std::path::PathBuf;

use clap::Args;
use glam::DVec3;

use self::beams::Beam;
use self::diagram::{DiagramOptions, Group};
use super::choose_method::{Settled, settle};
use super::decisions::Rays;
use super::frames::Film;
use super::options::{DeviceFlags, SceneOptions};
use super::render::warn;
use super::{of_scene, paths};
use crate::error::Error;
use crate::gpu::Gpu;
use crate::measure::{Curve, Jacobian, OpticalPath, drift, jacobians, optical_paths, refuses_optical_paths};
use crate::model::Radiation;
use crate::output::csv::read_rays;
use crate::output::plot::check_plot;
use crate::output::table::Table;
use crate::program::Layer;
use crate::render::{
    self, Crossing, PathPoint, RenderSettings, StartUp, Totals, Traced, Tracer, Transferred, pixel_starts, trace,
    trace_paths,
};
use crate::scene::{CutPlane, Precision, Scene};

/// Trace given rays with the same passes as an image, and write their end points or draw their paths
#[derive(Debug, Args)]
#[command(group(clap::ArgGroup::new("starts").args(["rays", "fan", "bundle", "pixel"]).required(true).multiple(true)))]
#[command(group(clap::ArgGroup::new("results").args(["output", "plot", "focus", "windings"]).required(true).multiple(true)))]
#[allow(clippy::struct_excessive_bools)] // flags, each by itself
pub(super) struct Arguments {
    /// The scene file, or - for standard input; its camera is used only with --pixel
    scene: PathBuf,
    /// A CSV file with the header x,y,z,vx,vy,vz: start and velocity of each ray, used unchanged
    /// (without forces and with `[radiation]`, the speed is that of light); `-` is standard input
    #[arg(long, value_name = "FILE")]
    rays: Option<PathBuf>,
    /// Rays from a point, such as "from=[-5,0,0] toward=[0,0,0] spread=30 count=9", with SPREAD degrees between the outermost rays
    /// (repeatable)
    #[arg(long, value_name = "FAN", value_parser = Beam::fan)]
    fan: Vec<Beam>,
    /// Parallel rays, such as "from=[-5,0,0] toward=[0,0,0] width=2 count=9", with WIDTH between the outermost rays (repeatable)
    #[arg(long, value_name = "BUNDLE", value_parser = Beam::bundle)]
    bundle: Vec<Beam>,
    /// The camera ray through the center of pixel X,Y, counted from the top left (repeatable)
    #[arg(long, value_name = "X,Y", value_parser = parse_pixel)]
    pixel: Vec<[u32; 2]>,
    /// Output file for the results: CSV, or arrays for Python if it ends in .npz; `-` is standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Write the end of every segment instead of the end of the path
    #[arg(long, requires = "output")]
    path: bool,
    /// Write the first four crossings of each ray with translucent surfaces, and the surface on which it ends, instead of the end of the
    /// path: position, radius r, azimuth φ, time t, redshift factor g, and the angle to the surface normal
    #[arg(long, requires = "output", conflicts_with = "path")]
    crossings: bool,
    /// Write the derivatives of the end by the direction at the start instead of the end: of its direction (d11 to d22), of its position
    /// (x11 to x22), and the magnification of a distant source
    #[arg(long, requires = "output", conflicts_with_all = ["path", "crossings"])]
    jacobian: bool,
    /// Write the length ∫ ds and the optical path ∫ n ds of each ray instead of its end, in media and along straight rays
    #[arg(long, requires = "output", conflicts_with_all = ["path", "crossings", "jacobian"])]
    optical_path: bool,
    /// Write the intensity and the optical depth of each ray at each frequency of [radiation] instead of its end
    #[arg(long, requires = "output", conflicts_with_all = ["path", "crossings", "jacobian", "optical_path"])]
    intensities: bool,
    /// Draw the paths in a plane, as SVG or PNG, with the surfaces that intersect it
    #[arg(long, value_name = "FILE", value_parser = paths::file())]
    plot: Option<PathBuf>,
    #[command(flatten)]
    diagram: DiagramOptions,
    /// Print the drift of the constants of motion (energy, angular momentum, |v| = n) along the rays
    #[arg(long, conflicts_with = "path")]
    drift: bool,
    #[command(flatten)]
    changes: SceneOptions,
    #[command(flatten)]
    device: DeviceFlags,
}

fn parse_pixel(text: &str) -> Result<[u32; 2], String> {
    let parsed = || {
        let (x, y) = text.split_once(',')?;
        Some([x.trim().parse().ok()?, y.trim().parse().ok()?])
    };
    parsed().ok_or_else(|| format!("expected a pixel as COLUMN,ROW, such as 320,240, found `{text}`"))
}

/// The accuracy of rays in 64 bits for Jacobians, in radians, unless the scene specifies one. Derivatives magnify errors of method.
const JACOBIAN_ACCURACY: f64 = 1e-8;

/// Checks that the scene can give the results of the arguments.
fn check(arguments: &Arguments, scene: &Scene) -> Result<(), Error> {
    if arguments.drift && scene.rays.sky_at_infinity {
        return Err(usage!("--drift cannot be combined with rays.sky_at_infinity, because rays then end at infinity"));
    }
    if arguments.diagram.attractor.is_some() && scene.law.facts().ignores_direction.is_none() {
        return Err(usage!("--attractor requires a flow such as law.kind = \"lorenz\""));
    }
    if scene.radiation.is_none() && arguments.intensities {
        return Err(of_scene(&arguments.scene, "--intensities requires [radiation] with frequencies".to_owned()));
    }
    if let Some(problem) = refuses_optical_paths(scene).filter(|_| arguments.optical_path) {
        return Err(of_scene(&arguments.scene, problem));
    }
    if let Some([x, y]) = arguments.pixel.iter().find(|[x, y]| *x >= scene.image.size[0] || *y >= scene.image.size[1]) {
        let [width, height] = scene.image.size;
        return Err(usage!("pixel {x},{y} is outside the image of {width}x{height} pixels"));
    }
    Ok(())
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Error> {
    arguments.device.check()?;
    let opening = arguments.device.open();
    let film = Film::new(&arguments.scene, arguments.changes.overrides()?).on(arguments.device.name());
    let mut scene = film.load(None)?;
    check(arguments, &scene)?;
    let is_double = scene.rays.precision == Precision::Double;
    if let Some(radiation) = scene.radiation.as_mut().filter(|_| arguments.intensities) {
        radiation.refine(is_double);
    }
    if arguments.jacobian && is_double {
        scene.rays.refine(JACOBIAN_ACCURACY);
    }
    let mut inputs = film.inputs();
    inputs.extend(arguments.rays.clone().map(|rays| (rays, "the file of rays")));
    paths::check(arguments.output.iter().chain(&arguments.plot).map(PathBuf::as_path), &inputs)?;
    for words in &scene.left_out {
        tell!("warning: {words}");
    }
    let mut starts = Starts::of(arguments, scene.law.facts().ignores_direction.is_none())?;
    let mut table = match &arguments.output {
        Some(output) if arguments.crossings => Some(Table::create::<(usize, usize, &Crossing)>(output)?),
        Some(output) if arguments.jacobian => Some(Table::create::<(usize, &Traced, Option<Jacobian>)>(output)?),
        Some(output) if arguments.optical_path => Some(Table::create::<(usize, OpticalPath)>(output)?),
        Some(output) if arguments.intensities => Some(Table::create::<(usize, &Traced, f64, Transferred)>(output)?),
        Some(output) if arguments.path => Some(Table::create::<(usize, usize, &PathPoint)>(output)?),
        Some(output) => Some(Table::create::<(usize, &Traced)>(output)?),
        None => None,
    };
    arguments.plot.as_deref().map_or(Ok(()), check_plot)?;
    let gpu = opening.finish()?;
    let settings = arguments.device.settings(Vec::new());
    starts.add_pixels(&gpu, &scene, &settings, &arguments.pixel)?;
    let rays = &starts.rays;
    let Settled { scene, settings, .. } =
        settle(&gpu, (&film, None), scene, settings, Rays::Given(rays), &mut StartUp::default())?;
    let all = (&starts, arguments.pixel.as_slice());
    if let Some(table) = table.as_mut().filter(|_| arguments.crossings) {
        let mut settings = settings.clone();
        settings.options.layers = vec![Layer::CrossingRadius];
        follow(&gpu, &scene, &settings, all, |first, _, tracer| write_crossings(first, tracer, table))?;
    }
    if let Some(table) = table.as_mut().filter(|_| arguments.jacobian) {
        let (ends, totals) = jacobians(&gpu, &scene, &settings, rays)?;
        for (i, (end, jacobian)) in ends.iter().enumerate() {
            table.write(&(i, end, *jacobian))?;
        }
        tell!("{totals}");
        warn(&totals);
    }
    if let Some(table) = table.as_mut().filter(|_| arguments.optical_path) {
        let mut totals = Totals::default();
        for (i, path) in optical_paths(&gpu, &scene, &settings, rays)?.into_iter().enumerate() {
            table.write(&(i, path))?;
            totals.add(&Totals { rays: 1, by_status: vec![(path.status, 1)], ..Totals::default() });
        }
        warn(&totals);
    }
    let radiation = scene.radiation.as_ref().filter(|_| arguments.intensities);
    if let Some((table, radiation)) = table.as_mut().zip(radiation) {
        let write = |first, ends: &[Traced], tracer: &Tracer| write_intensities(radiation, first, ends, tracer, table);
        follow(&gpu, &scene, &settings, all, write)?;
    }
    let others =
        [arguments.path, arguments.crossings, arguments.jacobian, arguments.optical_path, arguments.intensities];
    let ends = table.is_some() && !others.contains(&true);
    if ends || arguments.drift {
        let (traced, totals) = trace(&gpu, &scene, &settings, rays)?;
        for (i, ray) in traced.iter().enumerate() {
            table.as_mut().filter(|_| ends).map_or(Ok(()), |table| table.write(&(i, ray)))?;
        }
        tell!("{totals}");
        warn(&totals);
        if arguments.drift {
            print_drift(&scene, rays, &traced);
        }
    }
    let drawn = arguments.plot.is_some() || arguments.diagram.focus || arguments.diagram.windings.is_some();
    if arguments.path || drawn {
        let paths = trace_paths(&gpu, &scene, &settings, rays)?;
        if let Some(table) = table.as_mut().filter(|_| arguments.path) {
            for (i, (_, points)) in paths.iter().enumerate() {
                for (index, point) in points.iter().enumerate() {
                    table.write(&(i, index, point))?;
                }
            }
        }
        if drawn {
            let diagram = arguments.diagram.of(starts.plane, &starts.groups, &paths);
            let time = arguments.diagram.attractor.zip(rays.first());
            let attractor = time.map(|(time, start)| attractor(&gpu, &scene, &settings, start, time)).transpose()?;
            diagram.finish(&scene, arguments.plot.as_deref(), attractor)?;
        }
    }
    Ok(table.map_or(Ok(()), Table::finish)?)
}

/// All rays in the order of the results: from the file, the fans, the bundles, and the camera.
struct Starts {
    rays: Vec<[f64; 6]>,
    groups: Vec<Group>,
    /// The requested plane, which contains the fans and bundles.
    plane: Option<CutPlane>,
}

impl Starts {
    /// Collects the rays of the arguments; `aimed` is `true` if the direction of a ray matters.
    fn of(arguments: &Arguments, aimed: bool) -> Result<Self, Error> {
        let read = |path| read_rays(path, aimed);
        let mut rays = arguments.rays.as_deref().map_or(Ok(Vec::new()), read)?;
        let file = arguments.rays.as_ref().map(|path| Group { name: path.display().to_string(), count: rays.len() });
        let mut groups: Vec<Group> = file.into_iter().collect();
        let beams = [arguments.fan.as_slice(), &arguments.bundle].concat();
        let plane = arguments.diagram.asked_plane(&beams, &rays);
        for (beam, own) in beams.iter().zip(beams::rays(&beams, plane.as_ref())?) {
            groups.push(Group { name: beam.name(), count: own.len() });
            rays.extend(own);
        }
        Ok(Self { rays, groups, plane })
    }

    /// Appends the rays of the camera.
    fn add_pixels(
        &mut self,
        gpu: &Gpu,
        scene: &Scene,
        settings: &RenderSettings,
        pixels: &[[u32; 2]],
    ) -> Result<(), Error> {
        if !pixels.is_empty() {
            self.groups.push(Group { name: "the camera rays".to_owned(), count: pixels.len() });
            self.rays.extend(pixel_starts(gpu, scene, settings, pixels)?);
        }
        Ok(())
    }
}

/// The number of pixels in a row of the list.
const PIXELS_A_ROW: u32 = 1024;

/// Follows the given rays and the camera's rays, which come last; `write` gets the index of the first ray of each part.
fn follow(
    gpu: &Gpu,
    scene: &Scene,
    settings: &RenderSettings,
    (starts, pixels): (&Starts, &[[u32; 2]]),
    mut write: impl FnMut(usize, &[Traced], &Tracer) -> Result<(), Error>,
) -> Result<(), Error> {
    let given = &starts.rays[..starts.rays.len() - pixels.len()];
    let parts =
        [(render::Starts::Given(given), given.len()), (render::Starts::Pixels(pixels, PIXELS_A_ROW), pixels.len())];
    let mut first = 0;
    for (part, count) in parts.into_iter().filter(|(_, count)| *count > 0) {
        let mut tracer = Tracer::new(gpu, scene, settings.clone(), part.mode())?;
        let (ends, totals) = tracer.follow(part)?;
        write(first, &ends, &tracer)?;
        first += count;
        tell!("{totals}");
        warn(&totals);
    }
    Ok(())
}

/// Writes the light of each ray at each frequency.
fn write_intensities(
    radiation: &Radiation,
    first: usize,
    ends: &[Traced],
    tracer: &Tracer,
    table: &mut Table,
) -> Result<(), Error> {
    for (ray, (end, spectrum)) in (first..).zip(ends.iter().zip(tracer.spectra())) {
        for (k, light) in spectrum.iter().enumerate() {
            let frequency = radiation.hertz(k).unwrap_or(radiation.frequencies[k]);
            table.write(&(ray, end, frequency, *light))?;
        }
    }
    Ok(())
}

/// Writes the crossings of each ray.
fn write_crossings(first: usize, tracer: &Tracer, table: &mut Table) -> Result<(), Error> {
    for (ray, crossings) in (first..).zip(tracer.crossings()) {
        for (order, crossing) in crossings.iter().flatten().enumerate() {
            table.write(&(ray, order, crossing))?;
        }
    }
    Ok(())
}

/// The initial fraction of an attractor's orbit that is not drawn, because it has not converged yet.
const ARRIVING: f64 = 0.1;
/// The maximum number of segments of that orbit.
const ORBIT: u32 = 1 << 16;

/// Traces the orbit that a flow approaches in the long run, ignoring all objects.
fn attractor(gpu: &Gpu, scene: &Scene, settings: &RenderSettings, start: &[f64; 6], time: f64) -> Result<Curve, Error> {
    let mut scene = scene.clone();
    scene.objects.clear();
    scene.rays.max_parameter = Some(time);
    scene.rays.max_segments = ORBIT;
    let (_, points) = trace_paths(gpu, &scene, settings, &[*start])?.remove(0);
    let near: Vec<PathPoint> = points.into_iter().filter(|point| point.tau > ARRIVING * time).collect();
    Ok(Curve::of(&near))
}

fn print_drift(scene: &Scene, rays: &[[f64; 6]], traced: &[Traced]) {
    let start = |[x, y, z, a, b, c]: [f64; 6]| {
        let x = DVec3::new(x, y, z);
        [x, scene.law.starting_velocity(x, DVec3::new(a, b, c))]
    };
    let found = drift(&*scene.law, rays.iter().map(|ray| start(*ray)).zip(traced));
    if found.is_empty() {
        tell!("no drift to report: the law has no constants of motion, or no ray ended");
        return;
    }
    tell!("{:<18}{:>12}{:>12}{:>12}", "relative drift", "median", "99 %", "max");
    for (name, q) in found {
        tell!("{name:<18}{q}");
    }
}
