//! `bentray render`: a scene to pictures.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::{Args, ValueEnum};
use indicatif::{ProgressBar, ProgressStyle};

use super::options::{DeviceFlags, SceneOptions};
use crate::error::Error;
use crate::measure::{Verification, method_words, verify};
use crate::output::{ImageWriter, Settings, open};
use crate::program::Layer;
use crate::render::{RenderError, Renderer, Status, Totals};
use crate::scene::Scene;

/// Render a scene to a PNG (to look at) or an EXR (linear colour and layers), or both
#[derive(Debug, Args)]
pub(super) struct Arguments {
    /// The scene file
    scene: PathBuf,
    /// Where to write: .png or .exr (repeatable)
    #[arg(short, long, required = true, value_name = "FILE")]
    output: Vec<PathBuf>,
    /// Layers of the EXR; all of them unless named
    #[arg(long, value_enum, value_delimiter = ',', value_name = "LAYER")]
    layers: Option<Vec<LayerName>>,
    #[command(flatten)]
    changes: SceneOptions,
    #[command(flatten)]
    device: DeviceFlags,
    /// Follow N random pixels again in 64 bits, and print and store with the picture how far it is from the truth
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    verify: Option<u32>,
    /// Exit with 1 if any ray could not be followed to its end
    #[arg(long)]
    strict: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum LayerName {
    /// Segments along the path, whole ones and a fraction
    Depth,
    /// Where the ray ended
    Position,
    /// The surface's normal
    Normal,
    /// The object, from 1; 0 for none
    Object,
    /// How the ray ended
    Status,
    /// Integration steps
    Steps,
    /// No layers, only colour
    None,
}

impl LayerName {
    fn layer(self) -> Option<Layer> {
        Some(match self {
            Self::Depth => Layer::Depth,
            Self::Position => Layer::Position,
            Self::Normal => Layer::Normal,
            Self::Object => Layer::Object,
            Self::Status => Layer::Status,
            Self::Steps => Layer::Steps,
            Self::None => return None,
        })
    }
}

fn is_exr(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("exr"))
}

impl Arguments {
    fn check(&self) -> Result<(), Error> {
        if self.layers.is_some() && !self.output.iter().any(|path| is_exr(path)) {
            return Err(Error::Usage("--layers are written to an EXR: name one with -o".to_owned()));
        }
        let twice = self.output.iter().enumerate().find(|(i, path)| self.output[..*i].contains(path));
        match twice {
            Some((_, path)) => Err(Error::Usage(format!("{} is named twice with -o", path.display()))),
            None => Ok(()),
        }
    }

    /// In the order of [`Layer::ALL`], each once; none without an EXR to hold them.
    fn layers(&self) -> Vec<Layer> {
        if !self.output.iter().any(|path| is_exr(path)) {
            return Vec::new();
        }
        let wanted: Option<Vec<Layer>> =
            self.layers.as_ref().map(|names| names.iter().filter_map(|name| name.layer()).collect());
        Layer::ALL.into_iter().filter(|layer| wanted.as_ref().is_none_or(|wanted| wanted.contains(layer))).collect()
    }
}

pub(super) fn run(arguments: &Arguments) -> Result<ExitCode, Error> {
    arguments.check()?;
    let scene = Scene::load(&arguments.scene, &arguments.changes.overrides())?;
    let layers = arguments.layers();
    // Opened and dropped: a path that cannot be written is found before the work.
    for path in &arguments.output {
        drop(open(path, &file_settings(&scene, path, &layers, &[]))?);
    }
    if scene.camera.is_none() {
        return Err(RenderError::NoCamera.into());
    }
    let gpu = arguments.device.open()?;
    let (scene, settings) = arguments.device.settle(&gpu, scene, arguments.device.settings(layers.clone()), None)?;
    let measured = arguments.verify.map(|count| verify(&gpu, &scene, &settings, count as usize)).transpose()?;
    if let Some(verification) = &measured {
        say!("{verification}");
    }
    let metadata = metadata(&scene, measured.as_ref());
    let mut writers = Vec::new();
    for path in &arguments.output {
        writers.push(open(path, &file_settings(&scene, path, &layers, &metadata))?);
    }
    let mut renderer = Renderer::new(&gpu, &scene, settings)?;
    if arguments.device.chooses_segments() {
        renderer.choose_segments()?;
    }
    let totals = render(&renderer, &mut writers)?;
    for writer in writers {
        writer.finish()?;
    }
    eprintln!("{totals}");
    warn(&totals);
    Ok(if arguments.strict && totals.unfollowed() > 0 { ExitCode::FAILURE } else { ExitCode::SUCCESS })
}

/// What the picture says of itself.
fn metadata(scene: &Scene, verification: Option<&Verification>) -> Vec<(String, String)> {
    let mut all = vec![("Software".to_owned(), concat!("bentray ", env!("CARGO_PKG_VERSION")).to_owned())];
    if let Some(verification) = verification {
        all.push(("method".to_owned(), method_words(scene.rays.method, scene.rays.control)));
        all.extend(verification.metadata());
    }
    all
}

fn file_settings(scene: &Scene, path: &Path, layers: &[Layer], metadata: &[(String, String)]) -> Settings {
    Settings {
        size: scene.image.size,
        exposure: scene.output.exposure,
        tonemap: scene.output.tonemap,
        bits: scene.output.bits,
        alpha: scene.is_transparent(),
        layers: if is_exr(path) { layers.to_vec() } else { Vec::new() },
        metadata: metadata.to_vec(),
    }
}

fn render(renderer: &Renderer, writers: &mut [Box<dyn ImageWriter>]) -> Result<Totals, RenderError> {
    // Hidden by indicatif itself where stderr is no terminal.
    let bar = ProgressBar::new(1000);
    if let Ok(style) = ProgressStyle::with_template("{bar:40} {percent:>3} %  {eta} left") {
        bar.set_style(style);
    }
    let totals = renderer.render(
        &mut |band| {
            let failed = |error| RenderError::Output(Box::new(error));
            writers.iter_mut().try_for_each(|writer| writer.write_band(&band)).map_err(failed)
        },
        &|done| bar.set_position((done * 1000.0) as u64),
    );
    bar.finish_and_clear();
    totals
}

/// Rays that were lost are named, whatever the exit code.
pub(super) fn warn(totals: &Totals) {
    let advice = [
        (Status::Alive, "had not ended when the passes ran out: this is a fault of bentray; please report it"),
        (Status::Exhausted, "used up rays.max_segments: raise it, or take longer steps"),
        (Status::Stalled, "stopped moving: their steps fell under what float32 resolves"),
        (Status::Failed, "became infinite or undefined: take shorter steps, or give sources a capture radius"),
    ];
    for (status, what) in advice {
        let count = totals.count(status);
        if count > 0 {
            eprintln!("warning: {count} rays {what} (black in the picture, `{}` in the status layer)", status.name());
        }
    }
}
