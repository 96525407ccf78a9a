//! Options that several commands share.

use std::panic;
use std::path::PathBuf;
use std::thread::{self, JoinHandle};
use std::time::Duration;

use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};

use super::paths;
use super::screen;
use crate::error::Error;
use crate::gpu::{Gpu, GpuError};
use crate::output::origin::{COMPARED, FOLLOWED};
use crate::output::said;
use crate::program::{Layer, ProgramOptions, RaySkipping, Schedule};
use crate::render::{RenderSettings, Window};
use crate::scene::{Override, Precision, follow_as};

/// Overrides for values of the scene
#[derive(Debug, Args)]
pub(super) struct SceneOptions {
    /// Set a key of the scene, such as `rays.scaled_step=0.05` or `objects.0.radius=2`; `rays.accuracy=` removes the key (repeatable)
    #[arg(long = "set", value_name = "KEY=VALUE")]
    set: Vec<Override>,
    /// Image size, instead of the scene's
    #[arg(long, value_name = "WxH", value_parser = parse_size)]
    size: Option<[u32; 2]>,
    /// Samples per pixel, instead of the scene's
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1_048_576))]
    samples: Option<u32>,
    /// Precision of the arithmetic, instead of the scene's
    #[arg(long, value_parser = one_of(Bits::all(), Bits::name, Bits::meaning))]
    precision: Option<Bits>,
    /// Use the integration method and all its settings from an image that bentray rendered (EXR or PNG), instead of the scene's
    #[arg(long, value_name = "PICTURE", value_parser = paths::file())]
    method_from: Option<PathBuf>,
}

/// A precision, or `None` if the method search chooses it.
#[derive(Debug, Clone, Copy)]
struct Bits(Option<Precision>);

impl Bits {
    fn all() -> impl Iterator<Item = Self> {
        Precision::ALL.map(Some).into_iter().chain([None]).map(Self)
    }

    fn name(self) -> &'static str {
        self.0.map_or("auto", Precision::name)
    }

    fn meaning(self) -> &'static str {
        self.0.map_or("Chosen with the method: 64 bits if 32 bits do not reach the accuracy", Precision::meaning)
    }
}

/// Creates a parser for one of these values by its name; the help lists the meaning of each.
pub(super) fn one_of<T: Copy + Send + Sync + 'static>(
    all: impl IntoIterator<Item = T>,
    name: fn(T) -> &'static str,
    meaning: fn(T) -> &'static str,
) -> impl TypedValueParser<Value = T> {
    let all: Vec<T> = all.into_iter().collect();
    let words: Vec<_> = all.iter().map(|one| PossibleValue::new(name(*one)).help(meaning(*one))).collect();
    let read = move |word: String| all.iter().copied().find(|one| name(*one) == word).ok_or("unknown value");
    PossibleValuesParser::new(words).try_map(read)
}

/// Creates a parser for the name of a schedule.
pub(super) fn schedules() -> impl TypedValueParser<Value = Schedule> {
    one_of(Schedule::ALL, Schedule::name, Schedule::meaning)
}

pub(super) fn parse_size(text: &str) -> Result<[u32; 2], String> {
    let parsed = text.split_once(['x', 'X', '×']).and_then(|(w, h)| Some([w.parse().ok()?, h.parse().ok()?]));
    let in_range = |size: &[u32; 2]| size.iter().all(|side| (1..=65536).contains(side));
    parsed
        .filter(in_range)
        .ok_or_else(|| format!("expected a size such as 800x600, with sides from 1 to 65536 pixels, found `{text}`"))
}

/// Parses the window `X,Y,WxH` of an image.
pub(super) fn parse_window(text: &str) -> Result<Window, String> {
    let parsed = || {
        let mut words = text.splitn(3, ',').map(str::trim);
        let (x, y, size) = (words.next()?.parse().ok()?, words.next()?.parse().ok()?, words.next()?);
        Some(Window { origin: [x, y], size: parse_size(size).ok()? })
    };
    parsed()
        .ok_or_else(|| format!("expected a window as LEFT,TOP,WIDTHxHEIGHT, such as 0,540,1920x270, found `{text}`"))
}

/// Parses a duration, in seconds.
pub(super) fn parse_seconds(text: &str) -> Result<Duration, String> {
    let parsed = text.parse().ok().and_then(|seconds| Duration::try_from_secs_f64(seconds).ok());
    parsed.ok_or_else(|| format!("expected a number of seconds such as 30 or 0.5, found `{text}`"))
}

/// Parses a number of bytes, with KiB, MiB, GiB or no unit.
pub(super) fn parse_bytes(text: &str) -> Result<u64, String> {
    let units = [("KiB", 10), ("MiB", 20), ("GiB", 30), ("", 0)];
    let parsed = units.into_iter().find_map(|(unit, shift)| {
        let number = text.strip_suffix(unit)?.trim_end().parse::<u64>().ok()?;
        number.checked_mul(1 << shift)
    });
    parsed.ok_or_else(|| format!("expected an amount of memory such as 512MiB, 1GiB or 100000000, found `{text}`"))
}

impl SceneOptions {
    /// Returns `true` if the method is from an image whose program kept the layers that a search compares.
    pub(super) fn is_compared(&self) -> bool {
        self.method_from.as_ref().is_some_and(|picture| said(picture, COMPARED).is_ok_and(|text| text == "true"))
    }

    /// Returns all overrides, in the form that the scene reader takes.
    pub(super) fn overrides(&self) -> Result<Vec<Override>, Error> {
        let method = self.method_from.as_ref().map(|picture| -> Result<_, Error> {
            let followed = said(picture, FOLLOWED)?;
            let picture = picture.display();
            let overrides = follow_as(&followed).map_err(|error| usage!("{picture}: {error}"))?;
            Ok(overrides.into_iter().map(|over| over.from_option(format!("--method-from {picture}"))).collect())
        });
        let method: Vec<Override> = method.transpose()?.unwrap_or_default();
        let size = self.size.map(|[w, h]| (format!("image.size=[{w}, {h}]"), format!("--size {w}x{h}")));
        let samples = self.samples.map(|n| (format!("image.samples={n}"), format!("--samples {n}")));
        let precision = self.precision.map(|precision| {
            let name = precision.name();
            (format!("rays.precision=\"{name}\""), format!("--precision {name}"))
        });
        let parse = |(text, option): (String, String)| Some(text.parse::<Override>().ok()?.from_option(option));
        let own = size.into_iter().chain(samples).chain(precision).filter_map(parse);
        Ok(method.into_iter().chain(self.set.iter().cloned()).chain(own).collect())
    }
}

/// The device, and the division of a render into passes
#[derive(Debug, Args)]
pub(super) struct DeviceFlags {
    /// Use the device whose name contains NAME; by default the first discrete GPU, else an integrated GPU, else a CPU
    #[arg(long, value_name = "NAME")]
    device: Option<String>,
    /// Grouping of the stages of a segment into dispatches; all schedules give the same image. By default `whole`, or `fused` if one of
    /// the flags below requires it
    #[arg(long, value_parser = schedules())]
    schedule: Option<Schedule>,
    /// Disable the early ray termination of Weiskopf et al. (2004): run terminated rays too
    #[arg(long)]
    no_early_termination: bool,
    /// Disable active-ray compaction; terminated rays are skipped in place (multi-pass schedules only)
    #[arg(long, conflicts_with = "no_early_termination")]
    no_compaction: bool,
    /// Segments per pass (K) of `fused`; by default, large images choose it by rendering at a small size first
    #[arg(long, value_name = "K", value_parser = clap::value_parser!(u32).range(1..=1024))]
    segments_per_pass: Option<u32>,
}

impl DeviceFlags {
    /// Rejects options that would have no effect.
    pub(super) fn check(&self) -> Result<(), Error> {
        match self.schedule.filter(|schedule| self.segments_per_pass.is_some() && !schedule.fuses()) {
            Some(schedule) => Err(usage!(
                "--segments-per-pass requires --schedule fused; a pass of `{}` never has several segments",
                schedule.name()
            )),
            None => Ok(()),
        }
    }

    /// Returns the requested device name, or a part of it.
    pub(super) fn name(&self) -> Option<&str> {
        self.device.as_deref()
    }

    /// Starts to open the device, while the scene is read.
    pub(super) fn open(&self) -> Opening {
        let name = self.device.clone();
        Opening(Some(thread::spawn(move || Gpu::open(name.as_deref()))))
    }

    /// Returns `true` if K is not specified.
    pub(super) fn chooses_segments(&self) -> bool {
        self.segments_per_pass.is_none()
    }

    /// Returns the requested schedule, or the schedule that the other flags require.
    fn schedule(&self) -> Schedule {
        let is_for_fused = self.no_early_termination || self.no_compaction || self.segments_per_pass.is_some();
        self.schedule.unwrap_or(if is_for_fused { Schedule::Fused } else { Schedule::Whole })
    }

    /// Returns the choice with the requested masks.
    fn masked(&self, options: ProgramOptions) -> ProgramOptions {
        let masks = match (self.no_early_termination, self.no_compaction) {
            (true, _) => RaySkipping::Off,
            (false, true) => RaySkipping::Grid,
            (false, false) => options.masks,
        };
        ProgramOptions { masks, ..options }
    }

    /// Returns the settings for images with these layers.
    pub(super) fn settings(&self, layers: Vec<Layer>) -> RenderSettings {
        let default = RenderSettings::default();
        RenderSettings {
            options: ProgramOptions { layers, ..self.masked(program_options(self.schedule())) },
            segments: self.segments_per_pass.unwrap_or(default.segments),
            ..default
        }
    }
}

/// A device that is being opened. Dropping it waits as well: a driver must not be interrupted while it starts.
pub(super) struct Opening(Option<JoinHandle<Result<Gpu, GpuError>>>);

impl Opening {
    /// Waits for the device, and prints its name.
    pub(super) fn finish(mut self) -> Result<Gpu, GpuError> {
        let stage = screen::progress().stage("opening the device");
        let opened = self.0.take().map(JoinHandle::join);
        let lost = || Err(GpuError::Lost("the device could not be opened".to_owned()));
        // A thread that panicked hit a bug in this code; the panic continues here.
        let gpu = opened.map_or_else(lost, |opened| opened.unwrap_or_else(|e| panic::resume_unwind(e)))?;
        drop(stage);
        tell!("device: {} ({:?}, {})", gpu.info.name, gpu.info.device_type, gpu.info.backend);
        Ok(gpu.reporting(screen::progress()))
    }
}

impl Drop for Opening {
    fn drop(&mut self) {
        drop(self.0.take().map(JoinHandle::join));
    }
}

/// Returns the choice of a schedule with its masks, for images without layers.
pub(super) fn program_options(schedule: Schedule) -> ProgramOptions {
    ProgramOptions { schedule, masks: schedule.masks(), ..ProgramOptions::default() }
}
