//! Renders frames one after the other, with the programs that were compiled for the first.

use std::collections::VecDeque;
use std::sync::mpsc::Receiver;
use std::thread;
use std::time::Instant;

use indicatif::{HumanBytes, HumanDuration};

use super::ahead::{Inputs, Loaded};
use super::picture::{Made, Picture};
use super::{Arguments, warn};
use crate::cli::choose_method::{Settled, settle};
use crate::cli::decisions::Rays;
use crate::cli::format::Deferred;
use crate::cli::frames::Film;
use crate::cli::interrupt;
use crate::cli::screen;
use crate::cli::share::{Band, Target};
use crate::cli::watch::PreviewFile;
use crate::error::Error;
use crate::gpu::Gpu;
use crate::measure::Verification;
use crate::output::BackgroundWriter;
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
    pub gpu: &'a Gpu,
    pub settings: RenderSettings,
    /// The layers of the files; the device may keep more.
    pub layers: &'a [Layer],
    pub verification: Option<Verification>,
    pub launch: StartUp,
    /// The renderer, with the number of the frame for which it was made; a search makes one for the first frame.
    pub renderer: Option<(Renderer<'a>, Option<u32>)>,
    /// `true` once something has been rendered.
    pub is_under_way: bool,
    /// Two frames that need different programs, once they are found.
    pub clash: Option<[f64; 2]>,
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

/// Prints warnings about problems that are known before the render.
fn warn_beforehand(inputs: &Inputs) {
    for words in inputs.leading.warnings() {
        tell!("warning: {words}");
    }
    let is_open = inputs.leading.animation.as_ref().is_some_and(|animation| animation.shutter > 0.0);
    if is_open && inputs.arguments.frames.is_some() && inputs.leading.image.samples == 1 {
        tell!(
            "warning: the shutter is open, but one sample per pixel shows no motion blur: raise image.samples \
             (--samples)"
        );
    }
}

impl Work<'_> {
    /// Renders the unfinished targets. Returns the number of rays that could not be followed.
    pub(super) fn render_all(
        &mut self,
        inputs: &mut Inputs,
        targets: &[Target],
        earlier: Option<&EarlierSamples>,
    ) -> Result<u64, Error> {
        warn_beforehand(inputs);
        let result = thread::scope(|scope| self.render_each(targets, &inputs.load_ahead(scope, targets), earlier));
        if let (Err(_), Some(frames)) = (&result, self.clash) {
            let keys = inputs.leading.animation.as_ref().map_or(&[][..], |animation| &animation.keys);
            return Err(inputs.film.other_program(keys, frames));
        }
        let unfollowed = result?;
        if self.there > 0 {
            tell!("{} of {} existed already, rendered with the same settings", self.there, targets.len());
        }
        if targets.iter().any(|target| target.frame.is_some()) {
            tell!("reproduce with: {}", self.again);
        }
        Ok(unfollowed)
    }

    fn render_each(
        &mut self,
        targets: &[Target],
        scenes: &Receiver<Result<Loaded, Error>>,
        earlier: Option<&EarlierSamples>,
    ) -> Result<u64, Error> {
        let (mut unfollowed, mut done) = (0, 0);
        let stage = (targets.len() > 1).then(|| screen::progress().counted(unit_of(targets), targets.len()));
        let mut written = VecDeque::new();
        let mut failure = None;
        for &target in targets {
            let Ok(loaded) = scenes.recv() else { break };
            match loaded.and_then(|loaded| self.render(target, loaded, earlier)) {
                Ok(next) => {
                    unfollowed += next.unfollowed;
                    written.push_back(next);
                }
                Err(error) => failure = Some(error),
            }
            if written.len() > most_written() {
                self.finish(&mut written, &mut done, stage.as_ref())?;
            }
            if failure.is_some() || interrupt::is_asked() {
                break;
            }
        }
        // The targets before a failure are complete, and their results are printed.
        let last = screen::progress().stage("finishing the files");
        while !written.is_empty() {
            self.finish(&mut written, &mut done, stage.as_ref())?;
        }
        drop((last, stage));
        failure.map_or(Ok(unfollowed), Err)
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
    fn render(
        &mut self,
        target: Target,
        Loaded { scene, is_finished, metadata: said, moments }: Loaded,
        earlier: Option<&EarlierSamples>,
    ) -> Result<Written, Error> {
        let begun = Instant::now();
        let Target { frame, band } = target;
        let layers = self.layers;
        if is_finished {
            self.there += 1;
            return Ok(Written { files: None, result: self.result(target, None), totals: None, unfollowed: 0 });
        }
        let preview = self.arguments.preview(&scene, layers, &said);
        let is_first = !std::mem::replace(&mut self.is_under_way, true);
        self.set_up(&scene, frame, is_first)?;
        self.open_shutter(&scene, frame, moments)?;
        let window = self.window(&scene, band)?;
        let writers = self.arguments.open(&scene, (target, window), layers, &said)?;
        let mut files = BackgroundWriter::new(writers);
        let ready = begun.elapsed();
        screen::advise(self.arguments.preview_advice(&scene, target));
        let Some((renderer, _)) = &mut self.renderer else {
            return Ok(Written { files: None, result: self.result(target, None), totals: None, unfollowed: 0 });
        };
        let totals = render(renderer, &mut files, &mut self.launch, (earlier, preview.as_ref(), layers))?;
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
        Deferred::of(&Picture { scene: &self.arguments.scene, target, files, made })
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
    fn set_up(&mut self, scene: &Scene, frame: Option<u32>, is_first: bool) -> Result<(), Error> {
        if let Some((renderer, first)) = &mut self.renderer {
            match (renderer.set_scene(scene.clone()), *first, frame) {
                // The small image of a search may need another program.
                (Err(RenderError::OtherProgram), ..) if is_first => self.renderer = None,
                (Err(RenderError::OtherProgram), Some(a), Some(b)) => {
                    self.clash = Some([a.into(), b.into()]);
                    return Err(RenderError::OtherProgram.into());
                }
                (result, ..) => result?,
            }
        }
        if self.renderer.is_none() {
            self.renderer = Some((Renderer::keeping(self.gpu, scene.clone(), self.settings.clone())?, frame));
        }
        let Some((renderer, _)) = self.renderer.as_mut().filter(|_| is_first) else { return Ok(()) };
        renderer.set_window(self.settings.window);
        if self.arguments.device.chooses_segments() {
            renderer.choose_segments()?;
        }
        if let Some(words) = expected(renderer, scene, self.settings.memory)? {
            tell!("{words}");
        }
        self.launch.count(StartPart::Program);
        Ok(())
    }

    /// Sets the shutter samples of a frame.
    fn open_shutter(&mut self, scene: &Scene, frame: Option<u32>, moments: Vec<Scene>) -> Result<(), Error> {
        let (Some(frame), Some((renderer, _))) = (frame, &mut self.renderer) else { return Ok(()) };
        let result = renderer.set_moments(moments);
        if let Err(RenderError::OtherProgram) = &result {
            let closes = scene.animation.as_ref().map_or(0.0, |animation| animation.shutter);
            self.clash = Some([f64::from(frame), f64::from(frame) + closes]);
        }
        Ok(result?)
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
