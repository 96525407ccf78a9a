//! The figures of scenes/thesis and scenes/groller: every command of their pages, rendered small and compared with a picture that was looked at.

use std::path::{Path, PathBuf};
use std::process::Command;

use bentray::scene::{Scene, Shadows};

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes").join(name)
}

/// The words of the page's render commands, as a shell splits them.
fn commands(folder: &Path) -> Vec<Vec<String>> {
    let page = std::fs::read_to_string(folder.join("README.md")).unwrap();
    let lines = page.lines().filter_map(|line| line.strip_prefix("    bentray render "));
    // What is quoted is every other part.
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

/// How far two pictures are apart in what the eye sees: sRGB values, averaged over pieces, for a fractal has no pixel of its own.
fn difference(a: &image::RgbImage, b: &image::RgbImage) -> f64 {
    assert_eq!(a.dimensions(), b.dimensions());
    let small = |picture: &image::RgbImage| image::imageops::thumbnail(picture, a.width() / 4, a.height() / 4);
    let (a, b) = (small(a), small(b));
    let off = a.as_raw().iter().zip(b.as_raw()).map(|(a, b)| f64::from(a.abs_diff(*b)));
    off.sum::<f64>() / a.as_raw().len() as f64
}

/// The scene of a page's command.
fn scene(folder: &Path, words: &[String]) -> Scene {
    let sets = words.iter().zip(&words[1..]).filter(|(flag, _)| *flag == "--set");
    let overrides: Vec<_> = sets.map(|(_, value)| value.parse().unwrap()).collect();
    Scene::load(&folder.join(&words[0]), &overrides).unwrap()
}

/// What makes a picture small: one sample of a few pixels, or where directions on the way of its light are drawn at random, so that
/// few samples are noise, of fewer pixels and some samples. (References of these have so many that their own noise is near 1 % of
/// the mean.) Rays are as accurate as such a pixel
/// can show, and a grid of light has as many paths as make no noise that is seen.
fn smaller(scene: &Scene, words: &[String]) -> Vec<String> {
    let (samples, size) = if scene.rays.paths.is_some() {
        ("64", "32x32")
    } else if scene.has_lobes() || scene.is_occluded() {
        ("16", "32x32")
    } else {
        ("1", "96x96")
    };
    let mut more = vec!["--samples".to_owned(), samples.to_owned()];
    if !words.iter().any(|word| word.starts_with("image.size")) {
        more.extend(["--size", size].map(str::to_owned));
    }
    let mut set = |key: String| more.extend(["--set".to_owned(), key]);
    if scene.rays.auto.is_some() {
        set("rays.accuracy=1e-2".to_owned());
    }
    for (k, light) in scene.lights.iter().enumerate() {
        if light.shadows == Shadows::Grid {
            set(format!("lights.{k}.paths=300000"));
        }
    }
    more
}

/// A picture as the page's command makes it, but small.
fn rendered(folder: &Path, words: &[String], to: &Path) -> image::RgbImage {
    let at = words.iter().position(|word| word == "-o").expect("an output") + 1;
    let (picture, name) = (to.join(&words[at]), shown(&words[at]));
    let mut words = words.to_owned();
    words[at] = picture.to_string_lossy().into_owned();
    // Of a film the frame that is compared.
    if let Some(frames) = words.iter().position(|word| word == "--frames") {
        LAST_FRAME.clone_into(&mut words[frames + 1]);
    }
    let mut command = Command::new(env!("CARGO_BIN_EXE_bentray"));
    command.current_dir(folder).env("BENTRAY_CACHE", "").arg("render").args(&words);
    let output = command.args(smaller(&scene(folder, &words), &words)).output().unwrap();
    assert!(output.status.success(), "{words:?}: {}", String::from_utf8_lossy(&output.stderr));
    image::open(to.join(name)).unwrap().to_rgb8()
}

/// Films of the pages have 48 frames.
const LAST_FRAME: &str = "47";

/// Of a film its last frame.
fn shown(name: &str) -> String {
    name.replace("{frame:2}", LAST_FRAME)
}

fn figures_are_as_they_were_looked_at(name: &str, least: usize) {
    let folder = folder(name);
    let to = tempfile::tempdir().unwrap();
    let all = commands(&folder);
    assert!(all.len() >= least, "{}", all.len());
    let mut off = Vec::new();
    for words in &all {
        let name = &words[words.iter().position(|word| word == "-o").expect("an output") + 1];
        let name = &shown(name);
        let reference = image::open(folder.join("pictures").join(name));
        let reference = reference.unwrap_or_else(|error| panic!("no reference for {name}: {error}")).to_rgb8();
        off.push((difference(&reference, &rendered(&folder, words, to.path())), name.clone()));
    }
    let far: Vec<_> = off.iter().filter(|(off, _)| *off > 4.0).collect();
    assert!(far.is_empty(), "off by so many of 255: {far:?}");
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
