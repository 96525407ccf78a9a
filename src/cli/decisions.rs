//! What `auto` has found, kept in the user's cache folder, so that the next render of the same scene does not search again.
//!
//! *Theory.* A search comes to the same decision whenever it is made, since costs are counted and rays are the same. So a decision may
//! be kept under everything that it depends on: the program, the device, the scene with its files and changes, and what is rendered
//! of it. Nothing depends on its being there: without it the search is made again, and the picture is the same.
//!
//! *Practice.* A decision is a small TOML file, named by a 128-bit hash. What cannot be read or written is as if it were not there.
//! `BENTRAY_CACHE` names another folder; where it is empty, nothing is kept.

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

/// The folder, instead of the user's.
const FOLDER: &str = "BENTRAY_CACHE";

/// The rays that a method is wanted for.
#[derive(Debug, Clone, Copy)]
pub(super) enum Rays<'r> {
    /// These.
    Given(&'r [[f64; 6]]),
    /// The camera's, so many.
    Camera(u64),
    /// Those from lights to places, as pairs of a place and a light.
    Between(&'r [[DVec3; 2]]),
}

/// What a search came to.
#[derive(Serialize, Deserialize)]
pub(super) struct Decision {
    /// What was said of it.
    pub said: String,
    /// And warned of.
    pub warning: Option<String>,
    /// How rays are followed, as [`Rays::followed`](crate::scene::Rays::followed) has it.
    pub followed: String,
    /// Has the program that was compiled all layers that the search compared?
    pub compared_layers: bool,
}

/// Where the decision of one search is kept.
pub(super) struct Place(PathBuf);

/// The folder; none where nothing is to be kept.
pub(super) fn folder() -> Option<PathBuf> {
    match env::var_os(FOLDER) {
        Some(folder) if folder.is_empty() => None,
        Some(folder) => Some(PathBuf::from(folder)),
        None => Some(dirs::cache_dir()?.join("bentray")),
    }
}

impl Place {
    /// For the rays of a scene; none where nothing can be kept.
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

    /// What is kept there.
    pub(super) fn find(&self) -> Option<Decision> {
        toml::from_str(&fs::read_to_string(&self.0).ok()?).ok()
    }

    /// Keeps a decision, if that can be done.
    pub(super) fn keep(&self, decision: &Decision) {
        let written = self.0.parent().and_then(|folder| {
            fs::create_dir_all(folder).ok()?;
            let mut file = tempfile::NamedTempFile::new_in(folder).ok()?;
            file.write_all(toml::to_string(decision).ok()?.as_bytes()).ok()?;
            file.persist(&self.0).ok()
        });
        // Without it the search is made again.
        drop(written);
    }
}

/// The program, which another build of the same version is not.
fn program() -> Option<(PathBuf, u64, std::time::SystemTime)> {
    let path = env::current_exe().ok()?;
    let file = fs::metadata(&path).ok()?;
    Some((path, file.len(), file.modified().ok()?))
}
