//! Loads the scene of the next target while one is rendered.

use std::sync::mpsc::{Receiver, sync_channel};
use std::thread::Scope;

use super::Arguments;
use crate::cli::frames::Film;
use crate::cli::origin::origin;
use crate::cli::share::Target;
use crate::error::Error;
use crate::gpu::Gpu;
use crate::program::Layer;
use crate::scene::Scene;

/// The inputs that the scenes of all targets are loaded from.
pub(super) struct Inputs<'a> {
    pub arguments: &'a Arguments,
    pub film: Film<'a>,
    pub gpu: &'a Gpu,
    /// The scene whose method is used for every frame.
    pub leading: Scene,
    /// The layers of the files.
    pub layers: &'a [Layer],
    /// The metadata that all images share.
    pub metadata: Vec<(String, String)>,
}

/// The scene of a target.
pub(super) struct Loaded {
    pub scene: Scene,
    /// `true` if the files of the target exist and match the current settings.
    pub is_finished: bool,
    /// The metadata of its images.
    pub metadata: Vec<(String, String)>,
    /// The scenes of its shutter samples; none if it is finished.
    pub moments: Vec<Scene>,
}

impl Inputs<'_> {
    /// Loads the scenes of all targets in order, on another thread, at most one ahead. The thread ends when the receiver is dropped;
    /// until then it alone uses the film, whose caches are not shared.
    pub(super) fn load_ahead<'s>(
        &'s mut self,
        scope: &'s Scope<'s, '_>,
        targets: &'s [Target],
    ) -> Receiver<Result<Loaded, Error>> {
        let (sender, receiver) = sync_channel(0);
        scope.spawn(move || {
            for target in targets {
                if sender.send(self.load(*target)).is_err() {
                    break;
                }
            }
        });
        receiver
    }

    fn load(&self, target: Target) -> Result<Loaded, Error> {
        let Target { frame, band } = target;
        let scene = match frame {
            None => self.leading.clone(),
            Some(_) => self.settled(self.arguments.load(&self.film, frame, None)?),
        };
        let own = origin(&self.film, frame, self.gpu, &scene)?;
        let metadata: Vec<_> = own.into_iter().chain(self.metadata.clone()).collect();
        // A still image is rendered again at each request.
        let is_kept = frame.is_some() || band.is_some();
        let is_finished = is_kept && self.arguments.is_finished(&scene, target, self.layers, &metadata);
        let moments = match frame.filter(|_| !is_finished) {
            Some(frame) => self.film.moments(frame, &scene)?,
            None => Vec::new(),
        };
        let moments = moments.into_iter().map(|moment| self.settled(moment)).collect();
        Ok(Loaded { scene, is_finished, metadata, moments })
    }

    /// Returns a scene with the first frame's method, if the scene leaves its method open.
    fn settled(&self, scene: Scene) -> Scene {
        if scene.rays.auto.is_none() {
            return scene;
        }
        let first = &self.leading.rays;
        let mut scene = scene.followed_by(first.method, first.control, first.closed_forms);
        scene.rays.max_segments = first.max_segments;
        scene.rays.precision = first.precision;
        scene
    }
}
