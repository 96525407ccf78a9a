//! Tools for several topics: a device, scenes, comparisons.

pub mod branches;
pub mod lens;
pub mod probe;
pub mod tree;

use std::fmt::Display;
use std::iter::zip;
use std::ops::Deref;
use std::path::Path;
use std::sync::{LazyLock, Mutex, MutexGuard, PoisonError};

use bentray::gpu::{Geometry, Gpu};
use bentray::program::{Program, ProgramOptions};
use bentray::render::Rendering;
use bentray::scene::Scene;
use wgpu::DeviceType;

/// Opens the default device of `render`. Without a device the tests fail with a message that names the package to install;
/// tests in f64 fail on a device that does not support it.
pub fn open() -> Gpu {
    Gpu::open(None).unwrap_or_else(|error| panic!("{error}"))
}

/// Returns an idle device with the passes that it has compiled, because opening a device takes longer than most tests use it.
pub fn gpu() -> Lent {
    let idle = idle().pop();
    Lent(Some(idle.unwrap_or_else(open)))
}

/// A device that is returned to the others when it is dropped.
pub struct Lent(Option<Gpu>);

impl Deref for Lent {
    type Target = Gpu;

    fn deref(&self) -> &Gpu {
        self.0.as_ref().unwrap()
    }
}

impl Drop for Lent {
    fn drop(&mut self) {
        idle().extend(self.0.take());
    }
}

fn idle() -> MutexGuard<'static, Vec<Gpu>> {
    static IDLE: Mutex<Vec<Gpu>> = Mutex::new(Vec::new());
    IDLE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Parses a scene; its files load relative to `scenes/`.
pub fn scene(text: &str) -> Scene {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/test.toml");
    Scene::parse(text, &path, &[]).unwrap_or_else(|error| panic!("{error}"))
}

/// Asserts that a schedule does not change an image.
pub fn assert_same_image(found: &Rendering, expected: &Rendering, what: &dyn Display) {
    if found.band != expected.band {
        let values = |picture: &Rendering| picture.band.color.concat();
        assert_rounding(&values(found), &values(expected), what);
    }
}

/// Asserts that two images that are not the same differ only where they may. On a CPU every schedule gives the same bits. Compilers of
/// GPUs merge multiplications and additions differently in each program, so there one value in fifty may differ by more than rounding.
pub fn assert_rounding(found: &[f32], expected: &[f32], what: &dyn Display) {
    let apart: Vec<f32> = zip(found, expected)
        .filter(|(x, y)| x.to_bits() != y.to_bits())
        .map(|(x, y)| (x - y).abs() / (1.0 + y.abs()))
        .collect();
    let far = apart.iter().filter(|apart| **apart > 1e-4).count();
    let most = apart.iter().copied().fold(0.0, f32::max);
    let rounding =
        gpu().info.device_type != DeviceType::Cpu && found.len() == expected.len() && far * 50 <= found.len();
    assert!(
        rounding,
        "{what}: {} color values differ, {far} of them by more than 1e-4, at most by {most}",
        apart.len()
    );
}

/// Returns the mean of an image's channel over its pixels, which all show the same point, and its standard error.
pub fn mean_of(picture: &Rendering, channel: usize) -> (f64, f64) {
    let plane = &picture.band.color[channel];
    let n = plane.len() as f64;
    let mean = plane.iter().map(|x| f64::from(*x)).sum::<f64>() / n;
    let squares = plane.iter().map(|x| (f64::from(*x) - mean).powi(2)).sum::<f64>();
    (mean, (squares / (n * (n - 1.0))).sqrt())
}

/// Returns every scene file of `scenes/`.
pub fn shipped_scenes() -> Vec<std::path::PathBuf> {
    scenes_in("scenes")
}

/// Returns every scene file of a folder of the project.
pub fn scenes_in(folder: &str) -> Vec<std::path::PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let entries = folder.read_dir().unwrap_or_else(|error| panic!("{error}"));
    let mut scenes: Vec<_> = entries
        .filter_map(|entry| entry.ok().map(|entry| entry.path()))
        .filter(|path| path.extension().is_some_and(|e| e == "toml"))
        .collect();
    scenes.sort();
    scenes
}

/// Returns every scene file below `scenes/`.
pub fn all_scenes() -> Vec<std::path::PathBuf> {
    let folders =
        ["", "/bench", "/groller", "/laws", "/light", "/paths", "/spacetimes", "/stability", "/thesis", "/volumes"];
    folders.iter().flat_map(|folder| scenes_in(&format!("scenes{folder}"))).collect()
}

/// Returns the program of every scene below `scenes/` as `render` links it by default, by the file's path in the project.
pub fn pictured() -> &'static [(String, Program)] {
    static PROGRAMS: LazyLock<Vec<(String, Program)>> = LazyLock::new(|| {
        let program = |path: std::path::PathBuf| {
            let scene = Scene::load(&path, &[]).unwrap_or_else(|error| panic!("{error}"));
            let geometry = Geometry::new(&scene);
            let program = Program::new(&scene, &geometry.analysis, &ProgramOptions::default(), geometry.extent());
            let name = path.strip_prefix(env!("CARGO_MANIFEST_DIR")).unwrap().to_str().unwrap().to_owned();
            (name, program.unwrap_or_else(|error| panic!("{error}")))
        };
        all_scenes().into_iter().map(program).collect()
    });
    &PROGRAMS
}

/// Returns every source file except unit tests, by its path in `src`.
pub fn sources() -> Vec<(String, String)> {
    fn read(folder: &Path, name: &str, found: &mut Vec<(String, String)>) {
        for entry in folder.read_dir().unwrap().map(|entry| entry.unwrap()) {
            let own = entry.file_name().into_string().unwrap();
            let name = if name.is_empty() { own.clone() } else { format!("{name}/{own}") };
            if own == "tests" || own == "tests.rs" {
                continue;
            }
            if entry.path().is_dir() {
                read(&entry.path(), &name, found);
            } else if entry.path().extension().is_some_and(|e| e == "rs") {
                found.push((name, std::fs::read_to_string(entry.path()).unwrap()));
            }
        }
    }
    let mut found = Vec::new();
    read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"), "", &mut found);
    found
}
