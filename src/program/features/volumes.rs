//! The features of light that matter emits and absorbs along rays, in volumes and in media.

use glam::DVec3;

use crate::assets::VolumeFormulas;
use crate::model::{Absorption, Camera};
use crate::program::{Layer, Mode, ProgramOptions};
use crate::scene::Scene;

/// The properties of matter along rays, and of the light of its frequencies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[expect(clippy::struct_excessive_bools, reason = "each is a separate question")]
pub struct VolumeFeatures {
    /// Matter emits and absorbs light along rays.
    pub transfers: bool,
    /// The motion adds the light of matter along its own steps.
    pub transfers_orbits: bool,
    /// Some matter is in volumes.
    pub has_volumes: bool,
    /// Some matter fills media.
    pub media_absorb: bool,
    /// Some medium absorbs light by a texture with jumps.
    pub has_jumps: bool,
    /// Some matter emits light into rays from the camera.
    pub emits: bool,
    /// Some matter absorbs light.
    pub absorbs: bool,
    /// Light has frequencies instead of colors.
    pub is_spectral: bool,
    /// The light of a step of a path counts once among the branches of a ray, and is scaled by its throughput.
    pub counts_transfer: bool,
    /// Optical depths are needed beyond the matter that is seen.
    pub keeps_depth: bool,
    /// Pieces of paths are tested for matter that is too thin to meet their points.
    pub bounds_matter: bool,
    /// Some of these test the formulas of media.
    pub bounds_media: bool,
    /// Matter may have an edge or a kink between the end of a piece and the next of its points.
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
        let has_absorption = scene.absorptions().next().is_some();
        let absorbs = has_absorption || scene.volumes.iter().any(|volume| !volume.formulas.is_clear());
        let is_seen = (absorbs || !scene.volumes.is_empty()) && (is_picture || is_spectral);
        let transfers = is_seen || absorbs && mode.leaves_light();
        let has_volumes = transfers && !scene.volumes.is_empty();
        let media_absorb = transfers && has_absorption;
        let glows = scene.volumes.iter().any(|volume| !volume.formulas.is_dark())
            || scene.absorptions().any(|own| own.emission != DVec3::ZERO);
        let emits = transfers && glows && !mode.leaves_light();
        let of_media = || scene.absorptions().filter_map(Absorption::formulas);
        let bounds_media = media_absorb && of_media().any(VolumeFormulas::varies);
        let has_interiors = scene.objects.iter().any(|object| object.interior().is_some());
        let shifts_volumes =
            has_volumes && !has_interiors && !mode.leaves_light() && scene.has_frequencies_of(mode.is_given());
        let has_lapse = facts.line_element().is_some_and(|element| element.lapse().is_some());
        let has_depths = mode.is_given() || options.layers.iter().any(|layer| matches!(layer, Layer::OpticalDepth(_)));
        Self {
            transfers,
            transfers_orbits: transfers && ends_with_steps,
            is_spectral: is_spectral && transfers,
            has_volumes,
            media_absorb,
            has_jumps: media_absorb && scene.absorptions().any(Absorption::jumps),
            emits,
            absorbs: transfers && absorbs,
            counts_transfer: transfers && if is_spectral { scene.scatters() } else { emits },
            keeps_depth: is_spectral && has_depths,
            bounds_matter: bounds_media || has_volumes && scene.volumes.iter().any(|volume| volume.formulas.varies()),
            bounds_media,
            has_edges: has_volumes && scene.volumes.iter().any(|volume| volume.formulas.has_edges())
                || media_absorb && scene.absorptions().any(|own| own.texture().is_some())
                || media_absorb && of_media().any(VolumeFormulas::has_edges),
            has_grids: scene.volumes.iter().any(|volume| !volume.grids.is_empty()),
            shifts_volumes,
            has_horizon: shifts_volumes && (scene.horizon().is_some() || has_lapse),
            volumes_change: has_volumes
                && (facts.changes_with_time || scene.volumes.iter().any(|volume| volume.formulas.changes()))
                || media_absorb && of_media().any(VolumeFormulas::changes),
            places_by_law: has_volumes && scene.places_volumes_by_law(),
            is_parallel: transfers && scene.camera.as_ref().is_some_and(Camera::is_parallel),
        }
    }
}
