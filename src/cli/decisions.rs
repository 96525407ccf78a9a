//! The decisions of `auto`, stored in the user's cache folder, so that the next render of the same scene does not search again.
//!
//! *Theory.* A search always reaches the same decision, since costs are counted and rays are identical. So a decision may be stored under
//! a hash of all its inputs: the program, the device, the scene with its files and overrides, and the part that is rendered. The image
//! does not depend on the cache: if a decision is missing, the search runs again.
//!
//! *Practice.* A decision is a small TOML file, named by a 128-bit hash. A file that cannot be read or written is treated as missing.
//! `BENTRAY_CACHE` names another folder; if it is empty, nothing is stored.

use std::env;
use std::fs;
use std::hash::Hash;
use std::io::Write;
use std::path::PathBuf;

use glam::DVec3;
use serde::{Deserialize, Serialize};
use siphasher::sip128::{Hasher128, SipHasher24};

use super::frames::Film;
use crate::gpu::Gpu;
use crate::render::RenderSettings;

/// The environment variable that names the folder.
const FOLDER: &str = "BENTRAY_CACHE";

/// The rays for which a method is searched.
#[derive(Debug, Clone, Copy)]
pub(super) enum Rays<'r> {
    /// Given rays.
    Given(&'r [[f64; 6]]),
    /// This number of rays of the camera.
    Camera(u64),
    /// Rays from lights to points, as pairs of a point and a light.
    Between(&'r [[DVec3; 2]]),
}

/// The result of a search.
#[derive(Serialize, Deserialize)]
pub(super) struct Decision {
    /// The message about the result.
    pub said: String,
    /// The warning about the result, if there was one.
    pub warning: Option<String>,
    /// The integration method, as a text of [`Rays::followed`](crate::scene::Rays::followed).
    pub followed: String,
    /// `true` if the compiled program has all layers that the search compared.
    pub compared_layers: bool,
}

/// The file that stores the decision of one search.
pub(super) struct DecisionFile(PathBuf);

/// Returns the folder, or `None` if nothing is stored.
pub(super) fn folder() -> Option<PathBuf> {
    match env::var_os(FOLDER) {
        Some(folder) if folder.is_empty() => None,
        Some(folder) => Some(PathBuf::from(folder)),
        None => Some(dirs::cache_dir()?.join("bentray")),
    }
}

impl DecisionFile {
    /// Returns the file for the rays of a scene, or `None` if nothing can be stored.
    pub(super) fn of(
        gpu: &Gpu,
        film: &Film,
        frame: Option<u32>,
        settings: &RenderSettings,
        rays: Rays,
    ) -> Option<Self> {
        let folder = folder()?;
        let mut hasher = SipHasher24::new();
        program()?.hash(&mut hasher);
        format!("{:?} {} {frame:?} {settings:?}", gpu.info, gpu.f64).hash(&mut hasher);
        match rays {
            Rays::Camera(count) => count.hash(&mut hasher),
            Rays::Between(pairs) => bytemuck::cast_slice::<_, u8>(pairs).hash(&mut hasher),
            Rays::Given(rays) => bytemuck::cast_slice::<_, u8>(rays).hash(&mut hasher),
        }
        film.hash(&mut hasher)?;
        Some(Self(folder.join(format!("{:032x}.toml", hasher.finish128().as_u128()))))
    }

    /// Returns the stored decision, if there is one.
    pub(super) fn find(&self) -> Option<Decision> {
        toml::from_str(&fs::read_to_string(&self.0).ok()?).ok()
    }

    /// Stores a decision, if possible.
    pub(super) fn keep(&self, decision: &Decision) {
        let written = self.0.parent().and_then(|folder| {
            fs::create_dir_all(folder).ok()?;
            let mut file = tempfile::NamedTempFile::new_in(folder).ok()?;
            file.write_all(toml::to_string(decision).ok()?.as_bytes()).ok()?;
            file.persist(&self.0).ok()
        });
        // If this fails, the search runs again next time.
        drop(written);
    }
}

/// Identifies the program; another build of one version differs.
fn program() -> Option<(PathBuf, u64, std::time::SystemTime)> {
    let path = env::current_exe().ok()?;
    let file = fs::metadata(&path).ok()?;
    Some((path, file.len(), file.modified().ok()?))
}
