//! `render --from`: shades the rays of a lens map.
//!
//! *Idea.* A map stores the keys of the scene that determine its paths. An image is shaded from it only if these are unchanged.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::frames::Film;
use super::origin::values;
use crate::error::Error;
use crate::gpu::Gpu;
use crate::output::origin::{Difference, FOLLOWED, LINES, SAMPLES, differences};
use crate::output::{OutputError, has_extension, lens_map};
use crate::render::{LensMap, RenderSettings, Renderer};
use crate::scene::Scene;

/// A lens map from which an image is shaded.
pub(super) struct EarlierMap {
    path: PathBuf,
    map: Arc<LensMap>,
    metadata: Vec<(String, String)>,
}

impl EarlierMap {
    /// Reads a map.
    pub(super) fn read(path: &Path) -> Result<Self, Error> {
        let (map, metadata) = lens_map::read_map(path)?;
        Ok(Self { path: path.to_owned(), map: Arc::new(map), metadata })
    }

    /// Loads the scene, with the integration method of the map.
    pub(super) fn load(&self, film: &Film) -> Result<Scene, Error> {
        let said = |wanted: &str| self.metadata.iter().find_map(|(key, text)| (key == wanted).then_some(text));
        let problem = "it does not record how its rays were traced; `bentray map` writes this".to_owned();
        let followed = said(FOLLOWED).filter(|_| said(LINES).is_some());
        let followed = followed.ok_or_else(|| OutputError::Part { path: self.path.clone(), problem })?;
        Ok(film.load_as(None, followed)?)
    }

    /// Rejects a scene that needs other rays than those of the map.
    pub(super) fn check(&self, film: &Film, scene: &Scene) -> Result<(), Error> {
        if let Some(problem) = scene.refuses_map() {
            return Err(usage!("--from {}: {problem}", self.path.display()));
        }
        if scene.has_stars() {
            let path = self.path.display();
            return Err(usage!(
                "--from {path}: a lens map cannot show `sky.stars`, which are between its rays; remove them with --set sky.stars="
            ));
        }
        let values = values(film, scene)?;
        let is_compared = |(key, _): &&(String, String)| values.iter().any(|(own, _)| own == key);
        let had: Vec<(String, String)> = self.metadata.iter().filter(is_compared).cloned().collect();
        let differ = differences([&had, &values], &[]);
        let Some(found) = differ.iter().find(|found| !may_differ(found, scene)) else { return Ok(()) };
        let [had, has] = [0, 1].map(|which| found.value(which));
        let what = if found.key == SAMPLES { "image.samples" } else { &found.key };
        Err(usage!(
            "--from {}: `{what}` is {has}, but the rays were traced with {had}; write a new map, or render without --from",
            self.path.display()
        ))
    }

    /// Creates a renderer that shades the rays of the map.
    pub(super) fn renderer<'a>(
        &self,
        gpu: &'a Gpu,
        scene: &Scene,
        settings: RenderSettings,
    ) -> Result<Renderer<'a>, Error> {
        Ok(Renderer::of_map(gpu, scene.clone(), settings, self.map.clone())?)
    }
}

/// The extensions of images, which determine no path.
const PICTURES: [&str; 6] = ["png", "jpg", "jpeg", "exr", "hdr", "gif"];

/// Returns `true` if a difference changes only how the ends of paths look.
fn may_differ(Difference { key, values }: &Difference, scene: &Scene) -> bool {
    match key.strip_prefix("file ") {
        // The key that names a file differs too.
        Some(_) if values.iter().any(Option::is_none) => true,
        Some(file) => PICTURES.iter().any(|extension| has_extension(Path::new(file), extension)),
        None => scene.is_look(key),
    }
}
