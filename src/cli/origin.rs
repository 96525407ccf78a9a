//! The metadata of an image: which program, scene and settings made it.

use std::fs;
use std::hash::Hasher;
use std::path::PathBuf;

use siphasher::sip128::{Hasher128, SipHasher24};

use super::frames::{Film, with_frame};
use super::screen;
use crate::error::Error;
use crate::gpu::Gpu;
use crate::measure::method_words;
use crate::output::origin::{DEVICE, FOLLOWED, LINES, LISTED, SAMPLES, SCENE, scale};
use crate::scene::{Scene, SceneError, followed_keys};

/// The program and its version.
const SOFTWARE: &str = concat!("bentray ", env!("CARGO_PKG_VERSION"));

/// Returns the metadata for a scene, or for a frame of its animation, whose method is chosen.
pub(super) fn origin(
    film: &Film,
    frame: Option<u32>,
    gpu: &Gpu,
    scene: &Scene,
) -> Result<Vec<(String, String)>, Error> {
    let rays = &scene.rays;
    let said = [
        ("Software", SOFTWARE.to_owned()),
        ("method", method_words(rays.method, rays.control)),
        ("max_segments", rays.max_segments.to_string()),
        (FOLLOWED, rays.followed()),
        (SAMPLES, scene.image.samples.to_string()),
        (DEVICE, gpu.words()),
    ];
    let lines = lines(film, frame)?;
    let hash = (SCENE, hash(lines.as_bytes()));
    let lines = (lines.len() <= LISTED).then_some((LINES, lines));
    let said = said.into_iter().chain([hash]).chain(lines).map(|(key, text)| (key.to_owned(), text));
    Ok(said.chain(scale(scene)).collect())
}

/// Returns the part of [`origin`] that needs no device: the scene of the image, and its number of samples.
pub(super) fn scene_origin(
    film: &Film,
    frame: Option<u32>,
    scene: &Scene,
) -> Result<[(&'static str, String); 2], Error> {
    Ok([(SCENE, hash(lines(film, frame)?.as_bytes())), (SAMPLES, scene.image.samples.to_string())])
}

/// Returns the program, the values of the scene and the number of samples, as in [`origin`].
pub(super) fn values(film: &Film, scene: &Scene) -> Result<Vec<(String, String)>, Error> {
    let lines = lines(film, None)?;
    let said = [(SCENE, hash(lines.as_bytes())), (LINES, lines), (SAMPLES, scene.image.samples.to_string())];
    let said = said.into_iter().chain([("Software", SOFTWARE.to_owned())]);
    Ok(said.map(|(key, text)| (key.to_owned(), text)).collect())
}

/// Returns every value of the scene, and a hash of every file that was loaded for it, one per line. The integration method, the number
/// of samples and the display settings are stored elsewhere, and are not included.
fn lines(film: &Film, frame: Option<u32>) -> Result<String, Error> {
    let mut values = with_frame(frame, |frame_of| Scene::listing(film.path, &film.overrides, frame_of))?;
    for key in followed_keys() {
        values.remove(&format!("rays.{key}"));
    }
    values.retain(|key, _| key != "image.samples" && (!key.starts_with("output.") || key == "output.clamp"));
    let mut lines: Vec<String> = values.into_iter().map(|(key, value)| format!("{key} = {value}")).collect();
    for path in film.files.borrow().paths() {
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        lines.push(format!("file {name} = {}", film.hash_of(path)?));
    }
    Ok(lines.join("\n"))
}

impl Film<'_> {
    /// Returns the hash of a file's bytes, which are read only once.
    pub(super) fn hash_of(&self, path: PathBuf) -> Result<String, SceneError> {
        if let Some(known) = self.hashes.borrow().get(&path) {
            return Ok(known.clone());
        }
        let _stage =
            screen::progress().stage(format!("hashing {}", path.file_name().unwrap_or_default().to_string_lossy()));
        let bytes = fs::read(&path).map_err(|source| SceneError::Read { path: path.clone(), source })?;
        let hash = hash(&bytes);
        self.hashes.borrow_mut().insert(path, hash.clone());
        Ok(hash)
    }
}

fn hash(bytes: &[u8]) -> String {
    let mut hasher = SipHasher24::new();
    hasher.write(bytes);
    format!("{:032x}", hasher.finish128().as_u128())
}
