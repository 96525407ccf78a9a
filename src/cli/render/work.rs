//! Renders frames one after the other, with the programs that were compiled for the first.

use std::collections::VecDeque;
use std::time::Instant;

use indicatif::{HumanBytes, HumanDuration};

use super::picture::{Made, Picture};
use super::{Arguments, warn};
use crate::cli::choose_method::{Settled, settle};
use crate::cli::decisions::Rays;
use crate::cli::format::Deferred;
use crate::cli::frames::Film;
use crate::cli::interrupt;
use crate::cli::origin::origin;
use crate::cli::screen;
use crate::cli::share::{Band, Target};
use crate::cli::watch::PreviewFile;
use crate::error::Error;
use crate::gpu::Gpu;
use crate::measure::Verification;
use crate::output::BackgroundWriter;
use crate::output::origin::COMPARED;
use crate::program::Layer;
use crate::progress::Stage;
use crate::render::{
    EarlierSamples, Preview, RenderError, RenderSettings, Renderer, StartPart, StartUp, Totals, Watch, Window,
};
use crate::scene::Scene;

/// The state of a render.
pub(super) struct Work<'a> {
    pub arguments: &'a Arguments,
    /// The command line that repeats it.
    pub again: String,
    pub film: Film<'a>,
    pub gpu: &'a Gpu,
    /// The scene whose method is used for every frame.
    pub leading: Scene,
    pub settings: RenderSettings,
    /// The layers of the files; the device may keep more.
    pub layers: Vec<Layer>,
    pub verification: Option<Verification>,
    pub launch: StartUp,
    /// The renderer, with the number of the frame for which it was made; a search makes one for the first frame.
    pub renderer: Option<(Renderer<'a>, Option<u32>)>,
    /// `true` once something has been rendered.
    pub is_under_way: bool,
    /// The number of targets that existed already.
    pub there: usize,
}

/// Returns the largest number of targets whose files are written while another is rendered: one for each core.
fn most_written() -> usize {
    std::thread::available_parallelism().map_or(1, |cores| cores.get().min(8))
}

/// A rendered target whose files may still be written.
struct Written {
    files: Option<BackgroundWriter>,
    /// The result to print when they are complete.
    result: Deferred,
    totals: Option<Totals>,
    /// The number of rays that could not be followed.
    unfollowed: u64,
}

impl Arguments {
    /// Returns the scene with its method, and settings that reuse the compiled program. The first whole frame of an animation
    /// determines the method of all frames, so that processes with other frames or parts make the same choice.
    pub(super) fn lead<'a>(
        &self,
        gpu: &'a Gpu,
        film: &Film,
        still: Scene,
        settings: RenderSettings,
        launch: &mut StartUp,
    ) -> Result<Settled<'a>, Error> {
        let frame = self.frames.as_ref().map(|_| 0);
        let frames = if frame.is_some() { still.animation.as_ref().map_or(1, |animation| animation.frames) } else { 1 };
        let scene = if frame.is_some() { self.load(film, frame, None)? } else { still };
        let [width, height] = scene.image.size.map(u64::from);
        let rays = u64::from(frames) * u64::from(scene.image.samples) * width * height;
        settle(gpu, (film, frame), scene, settings, Rays::Camera(rays), launch)
    }
}

impl Work<'_> {
    /// Prints warnings about problems that are known before the render.
    fn warn_beforehand(&self) {
        for words in self.leading.warnings() {
            tell!("warning: {words}");
        }
        let is_open = self.leading.animation.as_ref().is_some_and(|animation| animation.shutter > 0.0);
        if is_open && self.arguments.frames.is_some() && self.leading.image.samples == 1 {
            tell!(
                "warning: the shutter is open, but one sample per pixel shows no motion blur: raise image.samples \
                 (--samples)"
            );
        }
    }

    /// Renders the unfinished targets. Returns the number of rays that could not be followed.
    pub(super) fn render_all(&mut self, targets: &[Target], earlier: Option<&EarlierSamples>) -> Result<u64, Error> {
        self.warn_beforehand();
        let (mut unfollowed, mut done) = (0, 0);
        let stage = (targets.len() > 1).then(|| screen::progress().counted(unit_of(targets), targets.len()));
        let mut written = VecDeque::new();
        for &target in targets {
            let next = match self.render(target, earlier) {
                Ok(next) => next,
                Err(error) => {
                    // The targets before it are complete, and their results are printed.
                    while !written.is_empty() {
                        self.finish(&mut written, &mut done, stage.as_ref())?;
                    }
                    return Err(error);
                }
            };
            unfollowed += next.unfollowed;
            written.push_back(next);
            if written.len() > most_written() {
                self.finish(&mut written, &mut done, stage.as_ref())?;
            }
            if interrupt::is_asked() {
                break;
            }
        }
        let last = screen::progress().stage("finishing the files");
        while !written.is_empty() {
            self.finish(&mut written, &mut done, stage.as_ref())?;
        }
        drop((last, stage));
        if self.there > 0 {
            tell!("{} of {} existed already, rendered with the same settings", self.there, targets.len());
        }
        if targets.iter().any(|target| target.frame.is_some()) {
            tell!("reproduce with: {}", self.again);
        }
        Ok(unfollowed)
    }

    /// Waits for the files of the first of these targets, and prints its result.
    fn finish(&self, written: &mut VecDeque<Written>, done: &mut usize, stage: Option<&Stage>) -> Result<(), Error> {
        let Some(Written { files, result, totals, .. }) = written.pop_front() else { return Ok(()) };
        files.map_or(Ok(()), BackgroundWriter::finish)?;
        self.arguments.format.tell(&result)?;
        if let Some(totals) = &totals {
            warn(totals);
        }
        *done += 1;
        interrupt::done(*done);
        if let Some(stage) = stage {
            stage.reach(*done as f64);
        }
        Ok(())
    }

    /// Renders a target, if it is not finished yet; its files are written in the background.
    fn render(&mut self, target: Target, earlier: Option<&EarlierSamples>) -> Result<Written, Error> {
        let begun = Instant::now();
        let Target { frame, band } = target;
        let scene = match frame {
            None => self.leading.clone(),
            Some(_) => settled(self.arguments.load(&self.film, frame, None)?, &self.leading),
        };
        let mut said = origin(&self.film, frame, self.gpu, &scene)?;
        said.push((COMPARED.to_owned(), (self.settings.options.layers != self.layers).to_string()));
        said.extend(self.verification.iter().flat_map(Verification::metadata));
        let layers = self.layers.clone();
        // A still image is rendered again at each request.
        if (frame.is_some() || band.is_some()) && self.arguments.is_finished(&scene, target, &layers, &said) {
            self.there += 1;
            return Ok(Written { files: None, result: self.result(target, None), totals: None, unfollowed: 0 });
        }
        let preview = self.arguments.preview(&scene, &layers, &said);
        let is_first = !std::mem::replace(&mut self.is_under_way, true);
        self.set_up(scene.clone(), frame, is_first)?;
        self.open_shutter(&scene, frame)?;
        let window = self.window(&scene, band)?;
        let writers = self.arguments.open(&scene, (target, window), &layers, &said)?;
        let mut files = BackgroundWriter::new(writers);
        let ready = begun.elapsed();
        screen::advise(self.arguments.preview_advice(&scene, target));
        let Some((renderer, _)) = &mut self.renderer else {
            return Ok(Written { files: None, result: self.result(target, None), totals: None, unfollowed: 0 });
        };
        let totals = render(renderer, &mut files, &mut self.launch, (earlier, preview.as_ref(), &layers))?;
        screen::advise(None);
        files.complete()?;
        let lights = self.renderer.as_ref().map(|(renderer, _)| renderer.light_reports()).unwrap_or_default();
        let made = Made {
            scene: &scene,
            again: &self.again,
            device: self.gpu.words(),
            window,
            ready,
            launch: is_first.then_some(&self.launch),
            totals,
            lights: &lights,
            verification: self.verification.as_ref(),
        };
        let (result, unfollowed) = (self.result(target, Some(&made)), made.unfollowed());
        Ok(Written { files: Some(files), result, totals: Some(made.totals), unfollowed })
    }

    /// Returns the result of a target; `made` is `None` if it was finished before.
    fn result(&self, target: Target, made: Option<&Made>) -> Deferred {
        let files = self.arguments.paths(target);
        Deferred::of(&Picture { scene: self.film.path, target, files, made })
    }

    /// Returns the window to render; for a band, the renderer is set to it.
    fn window(&mut self, scene: &Scene, band: Option<Band>) -> Result<Window, RenderError> {
        let (Some(band), Some((renderer, _))) = (band, &mut self.renderer) else {
            return Ok(self.arguments.window(scene));
        };
        let cuts = renderer.cuts(band.count)?;
        let [top, bottom] = [0, 1].map(|i| cuts[band.number as usize + i]);
        let window = Window { origin: [0, top], size: [scene.image.size[0], bottom - top] };
        renderer.set_window(Some(window));
        Ok(window)
    }

    /// Creates a renderer, or moves the existing one to another frame.
    fn set_up(&mut self, scene: Scene, frame: Option<u32>, is_first: bool) -> Result<(), Error> {
        if let Some((renderer, first)) = &mut self.renderer {
            match (renderer.set_scene(scene.clone()), *first, frame) {
                // The small image of a search may need another program.
                (Err(RenderError::OtherProgram), ..) if is_first => self.renderer = None,
                (Err(RenderError::OtherProgram), Some(a), Some(b)) => {
                    return Err(self.other_program([a.into(), b.into()]));
                }
                (result, ..) => result?,
            }
        }
        if self.renderer.is_none() {
            self.renderer = Some((Renderer::keeping(self.gpu, scene, self.settings.clone())?, frame));
        }
        let Some((renderer, _)) = self.renderer.as_mut().filter(|_| is_first) else { return Ok(()) };
        renderer.set_window(self.settings.window);
        if self.arguments.device.chooses_segments() {
            renderer.choose_segments()?;
        }
        if let Some(words) = expected(renderer, &self.leading, self.settings.memory)? {
            tell!("{words}");
        }
        self.launch.count(StartPart::Program);
        Ok(())
    }

    /// Sets the shutter samples of a frame.
    fn open_shutter(&mut self, scene: &Scene, frame: Option<u32>) -> Result<(), Error> {
        let (Some(frame), Some((renderer, _))) = (frame, &mut self.renderer) else { return Ok(()) };
        let moments = self.film.moments(frame, scene)?.into_iter();
        match renderer.set_moments(moments.map(|moment| settled(moment, &self.leading)).collect()) {
            Err(RenderError::OtherProgram) => {
                let closes = scene.animation.as_ref().map_or(0.0, |animation| animation.shutter);
                Err(self.other_program([f64::from(frame), f64::from(frame) + closes]))
            }
            result => Ok(result?),
        }
    }

    fn other_program(&self, frames: [f64; 2]) -> Error {
        let keys = self.leading.animation.as_ref().map_or(&[][..], |animation| &animation.keys);
        self.film.other_program(keys, frames)
    }
}

/// The number of rays above which the expected time and memory are printed before the start.
const MANY: u64 = 1 << 27;

/// Describes the time and memory that a large image will need.
fn expected(renderer: &mut Renderer, scene: &Scene, memory: u64) -> Result<Option<String>, RenderError> {
    let [width, height] = renderer.window().size;
    let rays = u64::from(width) * u64::from(height) * u64::from(scene.image.samples);
    if rays < MANY {
        return Ok(None);
    }
    let time = HumanDuration(renderer.expected_time()?);
    let least = if scene.image.adaptive.is_some() { "at least " } else { "" };
    let [device, plane] = [memory, 4 * u64::from(width) * u64::from(height)].map(HumanBytes);
    Ok(Some(format!(
        "{width}×{height} pixels with {} samples, {rays} rays: {least}about {time}, up to {device} of device memory \
         (--memory), and {plane} of disk space per channel (uncompressed)",
        scene.image.samples
    )))
}

/// Returns the unit in which targets are counted.
fn unit_of(targets: &[Target]) -> &'static str {
    if targets.iter().any(|target| target.band.is_some()) { "part" } else { "frame" }
}

/// Returns a scene with the first frame's method, if the scene leaves its method open.
fn settled(scene: Scene, first: &Scene) -> Scene {
    if scene.rays.auto.is_none() {
        return scene;
    }
    let mut scene = scene.followed_by(first.rays.method, first.rays.control, first.rays.closed_forms);
    scene.rays.max_segments = first.rays.max_segments;
    scene.rays.precision = first.rays.precision;
    scene
}

fn render(
    renderer: &mut Renderer,
    files: &mut BackgroundWriter,
    launch: &mut StartUp,
    (earlier, preview, layers): (Option<&EarlierSamples>, Option<&PreviewFile>, &[Layer]),
) -> Result<Totals, RenderError> {
    let preview = preview.map(|preview| -> &dyn Preview { preview });
    renderer.render_watched(
        &mut |band| {
            if !launch.is_complete() {
                launch.count(StartPart::FirstPicture);
            }
            files.write_band(band).map_err(|error| RenderError::Output(Box::new(error)))
        },
        &Watch { earlier, preview, layers: Some(layers) },
    )
}
