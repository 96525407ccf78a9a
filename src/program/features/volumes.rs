//! The features of light that volumes emit and absorb along rays.

use crate::model::Camera;
use crate::program::{Layer, Mode, ProgramOptions};
use crate::scene::Scene;

/// The properties of a scene's volumes, and of the light of their frequencies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[expect(clippy::struct_excessive_bools, reason = "each is a separate question")]
pub struct VolumeFeatures {
    /// Volumes emit and absorb light along rays.
    pub transfers: bool,
    /// The motion adds the light of volumes along its own steps.
    pub transfers_orbits: bool,
    /// Light has frequencies instead of colors.
    pub is_spectral: bool,
    /// The light of a step of a path counts once among the branches of a ray, and is scaled by its throughput.
    pub counts_transfer: bool,
    /// Optical depths are needed beyond the matter that is seen.
    pub keeps_depth: bool,
    /// Some volume absorbs light.
    pub absorbs_volumes: bool,
    /// Pieces of paths are tested for matter that is too thin to meet their points.
    pub bounds_matter: bool,
    /// Matter may end at an edge between the points of a piece.
    pub has_edges: bool,
    /// Formulas use samples on grids.
    pub has_grids: bool,
    /// The motion of matter and of the camera changes the frequency of light.
    pub shifts_volumes: bool,
    /// Matter may shine down to a horizon.
    pub has_horizon: bool,
    /// The time is needed where matter is.
    pub volumes_change: bool,
    /// Formulas of volumes use the coordinates of the law instead of those around their centers.
    pub places_by_law: bool,
    /// The camera's rays are parallel, and light has its frequency at infinity.
    pub is_parallel: bool,
}

impl VolumeFeatures {
    /// Determines the features; `ends_with_steps` is `true` if the last step of a path ends where the path ends.
    pub(super) fn of(scene: &Scene, options: &ProgramOptions, ends_with_steps: bool) -> Self {
        let mode = options.mode;
        let (is_picture, facts) = (mode == Mode::Picture, scene.law.facts());
        let is_spectral = scene.radiation.is_some() && (is_picture || matches!(mode, Mode::Trace | Mode::Pixels));
        let transfers = !scene.volumes.is_empty() && (is_picture || is_spectral);
        let has_interiors = scene.objects.iter().any(|object| object.interior().is_some());
        let shifts_volumes = transfers && !has_interiors && scene.has_frequencies_of(mode.is_given());
        let has_lapse = facts.line_element().is_some_and(|element| element.lapse().is_some());
        let has_depths = mode.is_given() || options.layers.iter().any(|layer| matches!(layer, Layer::OpticalDepth(_)));
        Self {
            transfers,
            transfers_orbits: transfers && ends_with_steps,
            is_spectral: is_spectral && transfers,
            counts_transfer: transfers && (!is_spectral || scene.scatters()),
            keeps_depth: is_spectral && has_depths,
            absorbs_volumes: scene.volumes.iter().any(|volume| !volume.formulas.is_clear()),
            bounds_matter: scene.volumes.iter().any(|volume| volume.formulas.varies()),
            has_edges: transfers && scene.volumes.iter().any(|volume| volume.formulas.has_edges()),
            has_grids: scene.volumes.iter().any(|volume| !volume.grids.is_empty()),
            shifts_volumes,
            has_horizon: shifts_volumes && (scene.horizon().is_some() || has_lapse),
            volumes_change: facts.changes_with_time || scene.volumes.iter().any(|volume| volume.formulas.changes()),
            places_by_law: scene.places_volumes_by_law(),
            is_parallel: transfers && scene.camera.as_ref().is_some_and(Camera::is_parallel),
        }
    }
}
