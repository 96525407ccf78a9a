//! `bentray render`: renders a scene to images.
//!
//! *Length.* Over 300 lines, because the options of `render` take half of it.

mod again;
mod ahead;
mod files;
mod picture;
mod video;
mod work;

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Duration;

use clap::Args;
use clap::builder::TypedValueParser;

use super::choose_method::Settled;
use super::continuation::EarlierImage;
use super::earlier_map::EarlierMap;
use super::format::Format;
use super::frame_list::Frames;
use super::frame_names::numbered;
use super::frames::Film;
use super::interrupt;
use super::options::{DeviceFlags, SceneOptions, one_of, parse_bytes, parse_seconds, parse_window};
use super::paths;
use super::share::{PartArg, Share, Target};
use super::{of_scene, say_line};
use crate::error::Error;
use crate::measure::{Verification, verify};
use crate::output::origin::COMPARED;
use crate::output::{has_extension, is_film, stores_layers};
use crate::program::Layer;
use crate::render::{EarlierSamples, RenderError, RenderSettings, StartPart, StartUp, Status, Totals, Window};
use crate::scene::Scene;
use ahead::Inputs;
pub(super) use picture::followed;
use work::Work;

/// Render a scene to a PNG (for viewing), to an EXR, NPZ or FITS file (linear color and layers), or to several of them
#[derive(Debug, Args)]
pub(super) struct Arguments {
    /// The scene file, or - for standard input; the files that it names are then relative to the working directory
    pub(super) scene: PathBuf,
    /// Output file: .png, .exr, .npz, .npy, .fits or .h5; with --frames also a video: .mp4, .webm, .gif or .png (repeatable)
    #[arg(short, long, required = true, value_name = "FILE", value_parser = paths::file())]
    output: Vec<PathBuf>,
    /// Layers of an .exr, .npz, .fits or .h5; by default all, with `samples` only if sampling is adaptive
    #[arg(long, value_parser = layers(), value_delimiter = ',', value_name = "LAYER")]
    layers: Option<Vec<Option<Layer>>>,
    #[command(flatten)]
    pub(super) changes: SceneOptions,
    #[command(flatten)]
    device: DeviceFlags,
    /// Render only this window of the image: its left column, top row and size. An EXR keeps its position in the whole image, so that
    /// `merge` can combine the windows
    #[arg(long, value_name = "X,Y,WxH", value_parser = parse_window, allow_hyphen_values = true)]
    crop: Option<Window>,
    /// Frames of the scene's [animation] to render: one number, A..B (inclusive), all, or a list of these, each with an optional step, such
    /// as 1,3,5..20:2. Each frame has its own files; the frame number replaces {frame} in the name, or {frame:4} with at least four
    /// digits; #### and %04d also work
    #[arg(long, value_name = "FRAMES", conflicts_with = "verify")]
    frames: Option<Frames>,
    /// Render one of N equal parts of the image or, with --frames, of the animation: 3/64 (counted from 1); auto takes the job number
    /// from Slurm, AWS Batch or SGE; auto/64 also works with Kubernetes, PBS and GNU parallel. Parts of an image are EXRs for `merge`;
    /// finished parts are not rendered again
    #[arg(long, value_name = "K/N", conflicts_with_all = ["crop", "verify", "earlier", "preview"])]
    part: Option<PartArg>,
    /// Add samples to an earlier path-traced image, up to the number in the scene: the result is bit-identical to one long render. The EXR
    /// must contain its accumulated sums, as it does unless --layers omits them
    #[arg(long = "continue", value_name = "EXR", conflicts_with = "frames", value_parser = paths::file())]
    earlier: Option<PathBuf>,
    /// Shade the rays of a lens map, which `bentray map` wrote for the same scene, and follow none: colors, the sky, lights and the output
    /// may differ
    #[arg(long, value_name = "EXR", value_parser = paths::file(),
        conflicts_with_all = ["frames", "part", "earlier", "preview", "verify"])]
    from: Option<PathBuf>,
    /// Write the unfinished image to this file during the render: .png or .exr, which may be continued
    #[arg(long, value_name = "FILE", conflicts_with = "frames", value_parser = paths::file())]
    preview: Option<PathBuf>,
    /// Seconds between two previews
    #[arg(long, value_name = "SECONDS", default_value = "30", requires = "preview", value_parser = parse_seconds)]
    preview_every: Duration,
    /// Device memory that the render may use: a larger image is rendered in tiles. Meshes, images and grids may use the same amount of host
    /// memory: a larger file is an error
    #[arg(long, value_name = "BYTES", default_value = "1GiB", value_parser = parse_bytes)]
    memory: u64,
    /// Trace N random pixels again in 64 bits; print the deviation from this reference solution and store it in the image
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    verify: Option<u32>,
    /// Exit with code 1 if any ray could not be traced to its end
    #[arg(long)]
    strict: bool,
    #[command(flatten)]
    pub(super) format: Format,
}

/// Creates a parser for the names of all layers, and for `none`.
fn layers() -> impl TypedValueParser<Value = Option<Layer>> {
    let all = Layer::ALL.into_iter().map(Some).chain([None]);
    one_of(
        all,
        |layer| layer.map_or("none", Layer::name),
        |layer| layer.map_or("No layers, only color", Layer::meaning),
    )
}

fn is_exr(path: &Path) -> bool {
    has_extension(path, "exr")
}

impl Arguments {
    fn check(&self) -> Result<(), Error> {
        self.device.check()?;
        if self.layers.is_some() && !self.output.iter().chain(&self.preview).any(|path| stores_layers(path)) {
            return Err(usage!(
                "--layers requires an output that stores layers: add an .exr, .npz, .fits or .h5 with -o"
            ));
        }
        let of_paths = |layer: &&Layer| layer.is_of_paths();
        if let Some(layer) = self.layers.iter().flatten().flatten().find(of_paths).filter(|_| self.from.is_some()) {
            return Err(usage!("--layers: `{}` describes a whole path, and --from has only its end", layer.name()));
        }
        if self.layers.as_ref().is_some_and(|layers| layers.len() > 1 && layers.contains(&None)) {
            return Err(usage!("--layers: `none` cannot be combined with other layers"));
        }
        let only_films = |path: &&PathBuf| self.frames.is_none() && is_film(path) && !has_extension(path, "png");
        if let Some(path) = self.output.iter().find(only_films) {
            let path = path.display();
            return Err(usage!("{path}: a video consists of frames; add --frames all, for a scene with [animation]"));
        }
        self.output.iter().try_for_each(|path| self.check_name(path))
    }

    /// Rejects a name without a frame number if there are frames, and a name with a frame number if there are none.
    fn check_name(&self, path: &Path) -> Result<(), Error> {
        let problem = match (numbered(path, 0), &self.frames) {
            (Err(problem), Some(_)) => problem,
            (Ok(Some(_)), None) => {
                "a placeholder for the frame number ({frame}, #### or %04d) requires --frames".to_owned()
            }
            (Ok(None), Some(_)) if !self.is_film(path) => {
                "--frames writes one file per frame, so the name needs {frame} or {frame:4}; the name of a video \
                 ends in .mp4, .webm, .gif or .png"
                    .to_owned()
            }
            _ => return Ok(()),
        };
        Err(usage!("{}: {problem}", path.display()))
    }

    /// Returns the requested frames, or a single `None` for a still image.
    pub(super) fn frames_of(&self, scene: &Scene) -> Result<Vec<Option<u32>>, Error> {
        match &self.frames {
            Some(frames) => Ok(frames.of(scene)?.into_iter().map(Some).collect()),
            None => Ok(vec![None]),
        }
    }

    /// Rejects options that cannot be combined with parts.
    pub(super) fn check_for_farm(&self) -> Result<(), Error> {
        self.check()?;
        if paths::is_standard(&self.scene) {
            return Err(usage!("-: {}", paths::NO_STREAM));
        }
        let alone = [
            (self.part.is_some(), "--part"),
            (self.crop.is_some(), "--crop"),
            (self.verify.is_some(), "--verify"),
            (self.earlier.is_some(), "--continue"),
            (self.preview.is_some(), "--preview"),
        ];
        match alone.into_iter().find(|(is_given, _)| *is_given) {
            Some((_, name)) => Err(usage!("{name} cannot be used with `farm`, which runs many renders; remove it")),
            None => Ok(()),
        }
    }

    /// Returns the targets to render, from these frames.
    fn targets(&self, frames: &[Option<u32>], scene: &Scene) -> Result<Vec<Target>, Error> {
        match self.part {
            Some(part) => targets_of(part.share()?, frames, scene),
            None => Ok(frames.iter().map(|&frame| Target { frame, band: None }).collect()),
        }
    }

    /// Loads the scene, one of its frames, or the scene of an image that is continued.
    fn load(&self, film: &Film, frame: Option<u32>, before: Option<&Before>) -> Result<Scene, Error> {
        let scene = match (frame, before) {
            (_, Some(Before::Image(image))) => image.load(film)?,
            (_, Some(Before::Map(map))) => map.load(film)?,
            (None, None) => film.load(None)?,
            (Some(frame), None) => film.load(Some(&|_| frame.into()))?,
        };
        let mut asked = self.layers.iter().flatten().copied().flatten();
        if let Some(refusal) = asked.find_map(|layer| layer.refused_by(&scene)) {
            return Err(usage!("{refusal}"));
        }
        match self.crop.filter(|window| !window.fits(scene.image.size)) {
            Some(window) => Err(RenderError::Window { window, picture: scene.image.size }.into()),
            None => Ok(scene),
        }
    }
}

/// An earlier result that a render starts from.
enum Before {
    /// An image that takes more samples.
    Image(Box<EarlierImage>),
    /// The ends of all paths.
    Map(EarlierMap),
}

impl Before {
    fn image(&self) -> Option<&EarlierImage> {
        match self {
            Self::Image(image) => Some(image),
            Self::Map(_) => None,
        }
    }

    fn samples(self) -> Option<EarlierSamples> {
        match self {
            Self::Image(image) => Some(image.earlier()),
            Self::Map(_) => None,
        }
    }
}

/// The maximum number of frames that are checked before any is rendered.
const AHEAD: usize = 24;

/// Returns the targets of a share of these frames.
pub(super) fn targets_of(share: Share, frames: &[Option<u32>], scene: &Scene) -> Result<Vec<Target>, Error> {
    let targets = share.of(frames);
    let rows = scene.image.size[1];
    let too_many = |target: &&Target| target.band.is_some_and(|band| band.count > rows);
    match targets.iter().find(too_many) {
        Some(_) => Err(usage!("--part: there are more parts than the {rows} rows of each image")),
        None => Ok(targets),
    }
}

pub(super) fn run(arguments: &Arguments) -> Result<ExitCode, Error> {
    let mut launch = StartUp::default();
    arguments.check()?;
    let opening = arguments.device.open();
    let film = Film::new(&arguments.scene, arguments.changes.overrides()?)
        .on(arguments.device.name())
        .within(arguments.memory);
    let earlier = match (&arguments.earlier, &arguments.from) {
        (Some(path), _) => Some(Before::Image(Box::new(EarlierImage::read(path)?))),
        (None, Some(path)) => Some(Before::Map(EarlierMap::read(path)?)),
        (None, None) => None,
    };
    let still = arguments.load(&film, None, earlier.as_ref())?;
    let before = earlier.as_ref().and_then(Before::image);
    let layers = arguments.layers(&still, before);
    if let Some(before) = before {
        before.check(&still, &layers, arguments.crop.unwrap_or(Window::whole(still.image.size)))?;
    }
    if let Some(Before::Map(map)) = &earlier {
        map.check(&film, &still)?;
    }
    let frames = arguments.frames_of(&still)?;
    let targets = arguments.targets(&frames, &still)?;
    if let Some(animation) = still.animation.as_ref().filter(|_| targets.len() > 1) {
        let frames: Vec<u32> = frames.iter().copied().flatten().collect();
        film.look_ahead(&arguments.device.settings(layers.clone()).options, animation, &frames, AHEAD)?;
    }
    arguments.check_files(&film, &targets)?;
    arguments.prepare_films(&still)?;
    arguments.try_files(&still, &targets, &layers)?;
    if still.camera.is_none() {
        return Err(of_scene(&arguments.scene, RenderError::NoCamera));
    }
    launch.count(StartPart::Scene);
    let gpu = opening.finish()?;
    if let Some(before) = before {
        before.check_origin(&film, &gpu, &still)?;
    }
    launch.count(StartPart::Device);
    let kept = arguments.kept(&still, &layers, before);
    let settings = RenderSettings { memory: arguments.memory, ..arguments.device.settings(kept) };
    let rate = still.animation.as_ref().map(|animation| animation.rate);
    let again = arguments.again(still.rays.auto.is_some() || before.is_some(), targets[0]);
    let is_film = arguments.frames.is_some();
    let Settled { scene: leading, settings, renderer, .. } = match &earlier {
        Some(Before::Map(map)) => {
            let settings = RenderSettings { window: arguments.crop, ..settings };
            let renderer = Some(map.renderer(&gpu, &still, settings.clone())?);
            Settled { scene: still, settings, renderer, light_tracer: None }
        }
        _ => arguments.lead(&gpu, &film, still, settings, &mut launch)?,
    };
    launch.count(StartPart::Method);
    let measured = arguments.verify.map(|count| verify(&gpu, &leading, &settings, count as usize)).transpose()?;
    // With `--json`, scripts get the verification together with the image.
    if let Some(verification) = measured.as_ref().filter(|_| !arguments.format.json) {
        // If nobody reads the output any more, the image is still written.
        match say_line(format_args!("{verification}")) {
            Err(Error::Closed) => {}
            other => other?,
        }
    }
    let settings = RenderSettings { window: arguments.crop, ..settings };
    if targets.len() > 1 {
        interrupt::finish_first(targets.len());
    }
    let compared = (COMPARED.to_owned(), (settings.options.layers != layers).to_string());
    let metadata = std::iter::once(compared).chain(measured.iter().flat_map(Verification::metadata)).collect();
    let mut inputs = Inputs { arguments, film, gpu: &gpu, leading, layers: &layers, metadata };
    let mut work = Work {
        arguments,
        again,
        gpu: &gpu,
        settings,
        layers: &layers,
        verification: measured,
        launch,
        renderer: renderer.map(|renderer| (renderer, is_film.then_some(0))),
        is_under_way: false,
        clash: None,
        there: 0,
    };
    let unfollowed = work.render_all(&mut inputs, &targets, earlier.and_then(Before::samples).as_ref())?;
    if let Some(code) = interrupt::stopped() {
        return Ok(code);
    }
    if let (Some(rate), None) = (rate, arguments.part) {
        arguments.make_films(&targets, rate)?;
        arguments.clear_frames(&targets);
    }
    Ok(if arguments.strict && unfollowed > 0 { ExitCode::FAILURE } else { ExitCode::SUCCESS })
}

/// Prints warnings for rays that were lost, whatever the exit code is.
pub(super) fn warn(totals: &Totals) {
    let advice = [
        (Status::Alive, "were active after the last pass", "this is a bug in bentray; report it"),
        (Status::Exhausted, "reached rays.max_segments", "raise it, or take longer steps"),
        (Status::Stalled, "stalled", "take longer steps, or use --precision f64"),
        (
            Status::Failed,
            "became infinite or undefined",
            "take shorter steps, give sources a capture radius, or correct a formula that is undefined there",
        ),
    ];
    if totals.undefined > 0 {
        tell!(
            "warning: {} of {} rays passed matter that is negative, not a number or faster than light, and show nothing: check \
             density, emission, absorption and flow of the volumes, and whether each transmittance is between 0 and 1",
            totals.undefined,
            totals.rays
        );
    }
    if totals.unsettled > 0 {
        tell!(
            "warning: light in matter did not converge to its tolerance on {} path segments, whose errors are larger: raise the \
             tolerance of `radiation` or `absorption` (0.001 for colors of volumes), use --precision f64, or smooth the edges \
             of the matter",
            totals.unsettled
        );
    }
    if totals.overrun > 0 {
        tell!(
            "warning: {} segments need more loop iterations than this device runs in one pass, and their rays \
             failed: use `acceleration = \"bvh\"`, fewer force sources, shorter loops in custom WGSL, or fewer steps \
             per segment; or render on a GPU",
            totals.overrun
        );
    }
    for (status, what, remedy) in advice {
        let (count, name) = (totals.count(status), status.name());
        if count > 0 {
            let share = 100.0 * count as f64 / totals.rays as f64;
            let rays = if count == 1 { "ray" } else { "rays" };
            tell!(
                "warning: {count} {rays} ({share:.2} %) {what} (black in the image, `{name}` in the status layer): {remedy}"
            );
        }
    }
}
