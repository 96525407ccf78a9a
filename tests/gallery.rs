//! Tests the figures of scenes/thesis and scenes/groller: every command of their pages, rendered small and compared with an
//! approved image.

use std::path::{Path, PathBuf};

use bentray::gpu::Gpu;
use bentray::measure::calibrate_for;
use bentray::output::save;
use bentray::program::{ProgramOptions, Schedule};
use bentray::render::{RenderSettings, Renderer};
use bentray::scene::{Files, Override, Scene, Shadows};

use crate::support::gpu;

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes").join(name)
}

/// Returns the words of the page's render commands as a shell splits them.
fn commands(folder: &Path) -> Vec<Vec<String>> {
    let page = std::fs::read_to_string(folder.join("README.md")).unwrap();
    let lines = page.lines().filter_map(|line| line.strip_prefix("    bentray render "));
    // Every second part is quoted.
    let words = |line: &str| -> Vec<String> {
        let parts = line.split('\'').enumerate();
        parts
            .flat_map(|(i, part)| match i % 2 {
                0 => part.split_whitespace().map(str::to_owned).collect(),
                _ => vec![part.to_owned()],
            })
            .collect()
    };
    lines.map(words).collect()
}

/// Returns the visible difference of two images: sRGB values, averaged over blocks because the pixels of a fractal are not reproducible.
fn difference(a: &image::RgbImage, b: &image::RgbImage) -> f64 {
    assert_eq!(a.dimensions(), b.dimensions());
    let small = |picture: &image::RgbImage| image::imageops::thumbnail(picture, a.width() / 4, a.height() / 4);
    let (a, b) = (small(a), small(b));
    let off = a.as_raw().iter().zip(b.as_raw()).map(|(a, b)| f64::from(a.abs_diff(*b)));
    off.sum::<f64>() / a.as_raw().len() as f64
}

/// The arguments of a command on a page.
struct Asked {
    scene: PathBuf,
    sets: Vec<Override>,
    schedule: Schedule,
    /// The last frame of a video.
    frame: Option<f64>,
    name: String,
}

impl Asked {
    /// Reads the words after `bentray render`.
    fn read(folder: &Path, words: &[String]) -> Self {
        let (scene, options) = words.split_first().expect("a scene");
        let mut asked = Self {
            scene: folder.join(scene),
            sets: Vec::new(),
            schedule: Schedule::Whole,
            frame: None,
            name: String::new(),
        };
        for option in options.chunks(2) {
            match [option[0].as_str(), option[1].as_str()] {
                ["--set", key] => asked.sets.push(key.parse().unwrap()),
                ["-o", name] => asked.name = name.replace("{frame:2}", LAST_FRAME),
                ["--frames", "all"] => asked.frame = LAST_FRAME.parse().ok(),
                ["--schedule", name] => {
                    asked.schedule = Schedule::ALL.into_iter().find(|schedule| schedule.name() == name).unwrap();
                }
                other => panic!("{other:?}"),
            }
        }
        asked
    }

    /// Loads the scene, at this time if it belongs to a video.
    fn load(&self, time: Option<f64>) -> Scene {
        let at = |time: f64| move |_: &str| time;
        let at = time.map(at);
        let frame_of = at.as_ref().map(|at| -> &dyn Fn(&str) -> f64 { at });
        Scene::load_with(&mut Files::default(), &self.scene, &self.sets, frame_of)
            .unwrap_or_else(|error| panic!("{error}"))
    }
}

/// Returns overrides for a small image: one sample for few pixels, or some samples for fewer pixels if directions are drawn
/// at random. (References of random images have so many samples that their noise is near 1 % of the mean.) Rays are as
/// accurate as such a pixel can show, and a photon grid has enough paths to make its noise invisible.
fn smaller(asked: &Asked) -> Vec<Override> {
    let scene = asked.load(None);
    let (samples, size) = if scene.rays.path_tracing.is_some() {
        (64, 32)
    } else if scene.has_lobes() || scene.is_occluded() {
        (16, 32)
    } else {
        (1, 96)
    };
    let mut more = vec![format!("image.samples={samples}")];
    if !asked.sets.iter().any(|set| set.text().starts_with("image.size")) {
        more.push(format!("image.size=[{size}, {size}]"));
    }
    if scene.rays.auto.is_some() {
        more.push("rays.accuracy=1e-2".to_owned());
    }
    let lights = scene.lights.iter().enumerate().filter(|(_, light)| light.shadows == Shadows::Grid);
    more.extend(lights.map(|(k, _)| format!("lights.{k}.paths=300000")));
    more.iter().map(|set| set.parse().unwrap()).collect()
}

/// Renders a small version of the page's image with the stages of `render`, on one device.
fn rendered(gpu: &Gpu, mut asked: Asked, to: &Path) -> image::RgbImage {
    asked.sets.extend(smaller(&asked));
    let (first, mut scene) = (asked.load(asked.frame.map(|_| 0.0)), asked.load(asked.frame));
    let options =
        ProgramOptions { schedule: asked.schedule, masks: asked.schedule.masks(), ..ProgramOptions::default() };
    let settings = RenderSettings { options, ..RenderSettings::default() };
    let [width, height] = scene.image.size.map(u64::from);
    let rays = width * height * u64::from(scene.image.samples);
    if let Some(found) = calibrate_for(gpu, &first, &settings, rays).unwrap() {
        scene = found.applied(&scene);
    }
    let picture = Renderer::new(gpu, &scene, settings).unwrap().render().unwrap();
    let path = to.join(&asked.name);
    save(&path, &scene, &picture).unwrap();
    image::open(path).unwrap().to_rgb8()
}

/// The videos on the pages have 48 frames.
const LAST_FRAME: &str = "47";

fn figures_are_as_they_were_looked_at(name: &str, least: usize) {
    let folder = folder(name);
    let to = tempfile::tempdir().unwrap();
    let all = commands(&folder);
    assert!(all.len() >= least, "{}", all.len());
    let mut off = Vec::new();
    let gpu = gpu();
    for words in &all {
        let asked = Asked::read(&folder, words);
        let name = asked.name.clone();
        let reference = image::open(folder.join("pictures").join(&name));
        let reference = reference.unwrap_or_else(|error| panic!("no reference for {name}: {error}")).to_rgb8();
        off.push((difference(&reference, &rendered(&gpu, asked, to.path())), name));
    }
    let far: Vec<_> = off.iter().filter(|(off, _)| *off > 4.0).collect();
    assert!(far.is_empty(), "differences out of 255: {far:?}");
}

#[test]
fn figures_of_the_thesis() {
    figures_are_as_they_were_looked_at("thesis", 43);
}

#[test]
fn images_of_1995() {
    figures_are_as_they_were_looked_at("groller", 14);
}

#[test]
fn spacetimes() {
    figures_are_as_they_were_looked_at("spacetimes", 33);
}
