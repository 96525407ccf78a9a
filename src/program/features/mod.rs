//! The features that a scene requires of its program, determined once; the plan follows from them.
//!
//! *Length.* Over 300 lines, because it is a list, with a field and a line for each feature.

mod constants;
mod grid;
mod passes;
mod volumes;

use grid::GridFeatures;
pub use grid::Margin;
pub use volumes::VolumeFeatures;

use super::regions::{RegionKind, Regions};
use super::{Analysis, DeviceProfile, Layer, Mode, PathEnds, ProgramOptions, RaySkipping, Schedule};
use crate::model::method::Path;
use crate::model::{Capture, StereoLayout};
use crate::scene::{Animation, Light, Precision, Scene, Segment, Shadows, Sky, Splitting, Tonemap};

/// All properties of a scene and its output that determine the modules of its program and the passes that run it.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
#[expect(clippy::struct_excessive_bools, reason = "each is a separate question")]
pub struct Features {
    /// The origin of the rays and the use of their results.
    pub mode: Mode,
    /// The schedule: the requested one, or `Fused` if the scene's paths do not fit into one pass.
    pub schedule: Schedule,
    /// The way in which terminated rays are skipped.
    pub masks: RaySkipping,
    /// The properties of the device.
    pub device: DeviceProfile,
    /// The layers to store, each once.
    pub layers: Vec<Layer>,
    /// The number format of rays.
    pub precision: Precision,
    /// The largest number of rounds per sample, in each of which every pixel follows one more path: the leaves of a full tree of paths.
    pub rounds: u32,
    /// The number of slots of the state: `paper` keeps a chord's start while its steps alternate between two more slots.
    pub slots: usize,

    /// The scene has objects.
    pub has_objects: bool,
    /// Some surface reflects or transmits rays.
    pub scatters: bool,
    /// Some surface both reflects and transmits.
    pub splits: bool,
    /// Some surface is translucent.
    pub is_translucent: bool,
    /// Some transparent object has a rough surface.
    pub has_rough_glass: bool,
    /// Objects have interiors, or closed mirrors have two sides.
    pub has_regions: bool,
    /// Some two-sided mesh reflects or transmits rays.
    pub has_sided_mesh: bool,
    /// Surfaces of objects touch.
    pub touches: bool,
    /// The refractive index of some medium depends on the wavelength.
    pub disperses: bool,
    /// Matter emits light in color into rays.
    pub sees_glow: bool,

    /// The light of matter along rays.
    pub volumes: VolumeFeatures,

    /// The image is path-traced.
    pub follows_paths: bool,
    /// Paths consist of several pieces, each of which needs the position at which it left a surface.
    pub in_pieces: bool,
    /// Paths use next-event estimation.
    pub aims: bool,
    /// Some emitter is sampled by its bounding box.
    pub emits_from_boxes: bool,
    /// The radiance of samples is clamped.
    pub clamps: bool,
    /// A path has a single wavelength.
    pub draws_wavelength: bool,
    /// Some surface is lit by a light.
    pub is_lit: bool,
    /// Some lights fall off with the squared distance.
    pub falls: bool,
    /// In a photon grid, the density of paths gives the brightness of some lights.
    pub grids_fall: bool,
    /// In photon grids, the density of paths gives the brightness of all lights.
    pub grids_all_fall: bool,
    /// Paths to lights are found by the shooting method.
    pub shoots: bool,
    /// Surfaces receive ambient light with ambient occlusion.
    pub is_occluded: bool,
    /// Ambient occlusion follows the paths of the law instead of straight lines.
    pub occludes_along_law: bool,
    /// Shadows are cast along straight lines.
    pub follows_lines: bool,
    /// Light is searched from surfaces, along lines or paths that begin there.
    pub looks_from_surfaces: bool,
    /// All lights cast shadows along straight lines.
    pub all_cast: bool,
    /// Transparent objects block light that arrives along straight lines.
    pub shuts_out: bool,
    /// Light that arrives at an image's surfaces along straight lines is partly absorbed.
    pub weakens_lines: bool,

    /// Rays end after a given length.
    pub is_limited: bool,
    /// The rounding error of the sum τ is stored separately.
    pub compensates_tau: bool,
    /// Something captures rays.
    pub captures: bool,
    /// Rays end according to a formula of a line element.
    pub captures_by_formula: bool,
    /// Photon orbits are inside the capture region; rays that turn there are not captured.
    pub is_extreme: bool,
    /// Rays continue from the bounding sphere to infinity.
    pub is_asymptotic: bool,
    /// Positions between the ends of a path are needed.
    pub needs_arcs: bool,
    /// Rays follow an orbit in closed form.
    pub on_orbit: bool,
    /// Orbits stay in a plane through the law's center.
    pub is_plane: bool,
    /// The center of the bounding sphere is the center of the orbit, in every frame.
    pub is_about_center: bool,
    /// The last integration step of a path ends where the path ends.
    pub ends_with_steps: bool,
    /// The last step is stored to compute the path's end.
    pub keeps_last: bool,
    /// The module that ends rays from below a horizon, if the camera may be there.
    pub below_part: Option<&'static str>,
    /// The state of a ray contains its time.
    pub carries_time: bool,
    /// τ is the path's length, whatever the speed.
    pub by_length: bool,
    /// The parametric curve that all rays follow is aligned with the axes of the camera.
    pub turns_with_camera: bool,
    /// Some object moves.
    pub travels: bool,
    /// The law is a wormhole.
    pub has_throat: bool,
    /// All paths are complete lines that begin at the start of the ray.
    pub joins_whole: bool,

    /// The far side of a wormhole has a different sky.
    pub has_two_skies: bool,
    /// The sky has stars.
    pub has_stars: bool,
    /// The rays through the centers of pixels are a grid, between which bundles of light are measured or stars are found.
    pub has_grid: bool,
    /// The only sample of each pixel is the ray of the grid.
    pub sample_is_grid: bool,
    /// The first sample of each pixel is at its center.
    pub centers_first: bool,
    /// That sample is the ray of the grid.
    pub first_is_grid: bool,
    /// The light of the sky is added after the bundles are measured.
    pub defers_sky: bool,
    /// The sky is transparent.
    pub sees_through: bool,
    /// Surfaces or the sky show images.
    pub has_images: bool,
    /// Some mesh has vertex colors.
    pub has_vertex_colors: bool,
    /// Pixels may be transparent.
    pub is_transparent: bool,
    /// Rays follow the branches at a surface one after the other.
    pub enumerates: bool,
    /// The arrangement of the two views of a stereo image, side by side or one above the other.
    pub views: Option<StereoLayout>,
    /// Sampling is adaptive: pixels take as many samples as they need.
    pub adapts: bool,
    /// Adaptive sampling compares pixels after the filmic tone map.
    pub is_filmic: bool,
    /// The size of a step is stored for the pass that intersects.
    pub keeps_taken: bool,
    /// More of a ray than X and V is stored between passes.
    pub keeps_w: bool,
    /// A ray cannot hit again the flat surface that it has just left.
    pub keeps_last_hit: bool,
    /// Some step crosses a whole region.
    pub has_leaps: bool,
    /// Traversal of the acceleration structure may be suspended if a pass reaches its loop budget.
    pub suspends: bool,
    /// All items of the acceleration structure have one kind, and are in the order of that kind.
    pub items_in_order: bool,
    /// Segments are chords over several steps.
    pub has_chords: bool,
    /// The steps of a chord are unrolled.
    pub writes_chords_out: bool,
    /// Steps are repeated if their error is too large.
    pub rejects: bool,
    /// Steps over the tolerance are kept, and counted as rejected.
    pub keeps_errors: bool,
    /// The objects of some kinds are in an acceleration structure.
    pub has_structure: bool,
    /// Some surface has a glossy highlight in path tracing.
    pub is_glossy: bool,
    /// The pixel footprints on images and patterns are computed.
    pub keeps_footprints: bool,
    /// The redshift changes the brightness of light.
    pub beams: bool,
    /// The redshift changes colors as it does for black bodies.
    pub shifts_hues: bool,
    /// The redshift is requested and defined.
    pub knows_shift: bool,
    /// The redshift is integrated along each path, because it is not conserved.
    pub follows_shift: bool,
    /// The source and the use of the ends of paths.
    pub ends: PathEnds,
    /// The first crossings of translucent surfaces are stored.
    pub keeps_crossings: bool,
    /// Light is separated by the crossing of translucent surfaces that it comes from.
    pub keeps_orders: bool,
}

impl Features {
    /// Determines the features of `scene`, rendered with `options`.
    #[must_use]
    #[expect(clippy::too_many_lines, reason = "a line for each feature")]
    pub fn of(scene: &Scene, options: &ProgramOptions, Analysis { regions, structure }: &Analysis) -> Self {
        let ProgramOptions { mode, masks, layers, device, ends, .. } = options.clone();
        let is_picture = mode == Mode::Picture;
        let (facts, camera) = (scene.law.facts(), scene.camera.as_ref());
        let (rounds, shoots) = (rounds(scene, is_picture), scene.has_shadows(Shadows::Shooting));
        let schedule = schedule(scene, options, is_picture && rounds == 1 && !shoots);
        let grids = || scene.lights.iter().filter(|light| light.shadows == Shadows::Grid);
        let beams = is_picture && camera.is_some_and(|camera| camera.redshift);
        let (joins_whole, ends_with_steps) =
            (regions.kinds.iter().all(|kind| joins_whole(scene, kind)), ends_with_steps(scene));
        let volumes = VolumeFeatures::of(scene, options, ends_with_steps);
        let knows_shift = beams || keeps_shift(scene, options) || volumes.shifts_volumes;
        let follows_paths = is_picture && scene.rays.path_tracing.is_some();
        let grid = GridFeatures::of(scene, options);
        let (is_occluded, follows_lines) = (scene.is_occluded(), scene.lines().next().is_some());
        Self {
            mode,
            schedule,
            masks,
            device,
            precision: scene.rays.precision,
            rounds,
            slots: slots(scene, schedule),
            has_objects: !scene.objects.is_empty(),
            keeps_taken: keeps_taken(scene, regions),
            keeps_w: facts.carries_time || scene.rays.control.kind.remembers || compensates_tau(scene),
            keeps_last_hit: scene.scatters() && (follows_paths && !joins_whole || is_flat(scene, regions)),
            has_leaps: regions.kinds.iter().any(|kind| kind.leaps),
            suspends: false,
            items_in_order: structure.in_order(),
            has_chords: scene.rays.segment.has_chords(),
            writes_chords_out: writes_out(scene),
            rejects: scene.rays.control.kind.rejects,
            scatters: scene.scatters(),
            splits: scene.splits(),
            is_translucent: scene.has_translucent(),
            has_rough_glass: scene.has_rough_glass(),
            has_sided_mesh: regions.regions.iter().any(|region| scene.objects[region.object].shape.mesh().is_some()),
            has_regions: !regions.regions.is_empty(),
            touches: regions.touching.count() > 0,
            disperses: scene.disperses(),
            sees_glow: is_picture && volumes.emits && !volumes.is_spectral,
            volumes,

            follows_paths,
            in_pieces: follows_paths && !joins_whole,
            aims: follows_paths && !scene.aims().is_empty(),
            emits_from_boxes: follows_paths && scene.emitters().iter().any(|emitter| emitter.edges.is_some()),
            clamps: follows_paths && scene.output.clamp.is_some(),
            draws_wavelength: scene.disperses() && (follows_paths || mode == Mode::Caustics),
            is_lit: scene.is_lit(),
            falls: scene.lights.iter().any(|light| light.falls),
            grids_fall: grids().any(Light::falls_in_grid),
            grids_all_fall: grids().all(Light::falls_in_grid),
            shoots: shoots || mode == Mode::Lit,
            is_occluded,
            occludes_along_law: is_occluded && scene.occlusion.is_some_and(|occlusion| occlusion.along_law),
            follows_lines,
            looks_from_surfaces: follows_lines || is_occluded,
            all_cast: scene.lights.iter().all(|light| light.shadows == Shadows::Straight),
            shuts_out: scene.shuts_out(),
            weakens_lines: is_picture && scene.weakens_lines(),

            is_limited: scene.rays.max_parameter.is_some(),
            compensates_tau: compensates_tau(scene),
            captures: !scene.captures(None).is_empty(),
            captures_by_formula: facts.line_element().is_some_and(|element| element.graph().4.is_some()),
            is_extreme: facts.turns_before_capture,
            is_asymptotic: scene.rays.sky_at_infinity,
            needs_arcs: scene.needs_arcs() || volumes.transfers && !ends_with_steps,
            on_orbit: scene.rays.method.kind.path == Path::Orbit,
            is_plane: facts.orbit.is_some_and(|orbit| orbit.is_plane()),
            is_about_center: is_about_center(scene),
            ends_with_steps,
            keeps_last: schedule == Schedule::Whole && keeps_last(scene, device.is_processor || ends_with_steps),
            below_part: below_part(scene, mode, facts.below),
            carries_time: facts.carries_time,
            by_length: facts.by_length,
            turns_with_camera: facts.curve().is_some_and(|curve| curve.turned.is_some()),
            travels: scene.travels().next().is_some(),
            has_throat: facts.throat.is_some(),
            joins_whole,
            has_two_skies: is_picture && scene.sky_other_side.is_some(),
            has_stars: grid.has_stars,
            has_grid: grid.exists,
            sample_is_grid: grid.is_sample && scene.image.samples == 1,
            centers_first: grid.centers_first,
            first_is_grid: grid.is_sample,
            defers_sky: grid.is_sample && grid.keeps_footprints,
            sees_through: is_picture && scene.sky == Sky::Transparent,
            has_images: !scene.pictures.is_empty(),
            has_vertex_colors: scene.uses_vertex_colors(),
            is_transparent: scene.is_transparent(),
            enumerates: is_picture && enumerates(scene),
            views: camera.and_then(|camera| Some(camera.stereo?.layout)),
            adapts: is_picture && scene.image.adaptive.is_some(),
            is_filmic: scene.output.tonemap == Tonemap::Filmic,
            keeps_errors: scene.rays.control.kind.keeps_errors,
            has_structure: !structure.solids.is_empty(),
            is_glossy: scene.used_materials().any(|material| material.surface.facts().is_glossy),
            keeps_footprints: grid.keeps_footprints,
            beams,
            shifts_hues: beams && camera.is_some_and(|camera| camera.color_shift),
            knows_shift,
            follows_shift: knows_shift && facts.changes_with_time,
            keeps_crossings: keeps_crossings(scene, options),
            ends,
            keeps_orders: is_picture && layers.contains(&Layer::ImageOrder) && scene.has_orders(),
            layers,
        }
    }

    /// Returns `true` if the program renders an image.
    #[must_use]
    pub fn is_picture(&self) -> bool {
        self.mode == Mode::Picture
    }

    /// Returns the frequencies whose light has its mean redshift stored, by their index.
    pub fn mean_redshifts(&self, scene: &Scene) -> impl Iterator<Item = usize> {
        let frequencies = if self.volumes.is_spectral { scene.frequencies() } else { 0 };
        let own = move |layer: &Layer| match layer {
            Layer::MeanRedshift(k) => Some(usize::from(*k)).filter(|k| *k < frequencies),
            _ => None,
        };
        self.layers.iter().filter_map(own)
    }

    /// Returns `true` if stored ends of paths are shaded, and no path is followed.
    #[must_use]
    pub fn shades_ends(&self) -> bool {
        self.ends == PathEnds::Given
    }

    /// Returns `true` if later rounds and samples process only the pixels that have a path left or need more samples.
    #[must_use]
    pub fn lists_open(&self) -> bool {
        self.masks != RaySkipping::Off && (self.rounds > 1 || self.adapts)
    }

    /// Returns `true` if the program stores the step counts of each ray.
    #[must_use]
    pub fn keeps_counts(&self) -> bool {
        matches!(self.mode, Mode::Trace | Mode::Pixels) || self.layers.contains(&Layer::Steps)
    }

    /// Returns `true` if the distance τ along the path is needed.
    #[must_use]
    pub fn asks_tau(&self) -> bool {
        self.needs_arcs
            || self.keeps_crossings
            || self.volumes.volumes_change
            || self.ends == PathEnds::Stored
            || !matches!(self.mode, Mode::Picture | Mode::Bare)
    }
}

/// Returns `true` if both rays of a split are followed, one after the other.
fn enumerates(scene: &Scene) -> bool {
    scene.scatters() && matches!(scene.rays.max_splits, Splitting::Enumerated(_))
}

/// Returns the schedule: a whole path `fits` into one pass only if a sample follows one path, and if its state need not be rounded between
/// segments.
fn schedule(scene: &Scene, options: &ProgramOptions, fits: bool) -> Schedule {
    let is_whole = fits && scene.rays.precision != Precision::Half && options.ends != PathEnds::Given;
    if options.schedule == Schedule::Whole && !is_whole { Schedule::Fused } else { options.schedule }
}

/// Returns `true` if the crossings of translucent surfaces are stored.
fn keeps_crossings(scene: &Scene, ProgramOptions { mode, layers, .. }: &ProgramOptions) -> bool {
    !scene.objects.is_empty() && !mode.leaves_light() && layers.iter().any(|layer| layer.is_of_crossings())
}

/// Returns `true` if the redshift is stored and defined.
fn keeps_shift(scene: &Scene, options: &ProgramOptions) -> bool {
    let of_pixels = options.mode == Mode::Picture && options.layers.contains(&Layer::Redshift);
    (of_pixels || keeps_crossings(scene, options)) && scene.has_frequencies_of(options.mode.is_given())
}

/// Returns the largest number of rounds per sample: one for each leaf of the full tree of a path.
fn rounds(scene: &Scene, is_picture: bool) -> u32 {
    match scene.rays.max_splits {
        Splitting::Enumerated(depth) if is_picture && scene.branches() => 1 << depth,
        _ => 1,
    }
}

/// Returns the number of slots of the state: `paper` keeps the start of a chord, and two more slots for its steps.
fn slots(scene: &Scene, schedule: Schedule) -> usize {
    let has_many_steps = matches!(scene.rays.segment, Segment::Chord { steps } if steps > 1);
    if schedule == Schedule::Paper && has_many_steps { 3 } else { 2 }
}

/// Returns the module that ends light from below a horizon, or `None` if the camera is known to be above it. An animation has one program
/// for all positions of its camera.
fn below_part(scene: &Scene, mode: Mode, below: Option<(&'static str, Capture)>) -> Option<&'static str> {
    let moves = |animation: &Animation| {
        animation.keys.iter().any(|key| ["camera.position", "camera.proper_time"].contains(&&**key))
    };
    let is_anywhere = mode.is_given() || scene.animation.as_ref().is_some_and(moves);
    let eye = scene.camera.as_ref().filter(|_| !is_anywhere).map(|camera| camera.position);
    let (part, horizon) = below?;
    eye.is_none_or(|eye| horizon.distance(eye) < 0.0).then_some(part)
}

/// Returns `true` if the rounding error of the sum τ is stored separately.
fn compensates_tau(scene: &Scene) -> bool {
    scene.rays.max_parameter.is_some() && scene.rays.precision != Precision::Double
}

/// Returns `true` if the paths of a kind of region are complete lines that begin at the start of the ray.
pub(super) fn joins_whole(scene: &Scene, kind: &RegionKind) -> bool {
    kind.motion.closed_form().is_some_and(|form| form.is_line) && !scene.rays.segment.has_chords()
}

/// Returns `true` if the last step of a path ends where the path ends, which holds for separable orbits in scenes with nothing to hit.
pub(super) fn ends_with_steps(scene: &Scene) -> bool {
    let separates = scene.law.facts().orbit.is_some_and(|orbit| !orbit.is_plane());
    let on_orbit = scene.rays.method.kind.path == Path::Orbit;
    on_orbit && separates && !scene.needs_arcs() && is_about_center(scene)
}

/// Returns `true` if the pass that takes the steps stores the last one of a path. On a GPU this costs up to 24 registers, so that it is only
/// worth while for steps that may be repeated; `is_cheap` is true elsewhere.
fn keeps_last(scene: &Scene, is_cheap: bool) -> bool {
    !scene.rays.segment.has_chords() && (is_cheap || scene.rays.control.kind.rejects)
}

/// Returns `true` if the center of the bounding sphere is the center of the orbits, in every frame.
fn is_about_center(scene: &Scene) -> bool {
    let moves = |key: &String| key.starts_with("law.") || key.starts_with("rays.bounding_sphere");
    let is_still = scene.animation.as_ref().is_none_or(|animation| !animation.keys.iter().any(moves));
    is_still && scene.law.facts().orbit.is_some_and(|orbit| orbit.center == scene.rays.bounding_sphere.center)
}

/// Returns `true` if rays may leave flat surfaces, which have no inside.
fn is_flat(scene: &Scene, regions: &Regions) -> bool {
    let mut continuing = scene.objects.iter().enumerate().filter(|(_, object)| scene.continues_from(object));
    scene.has_translucent() || continuing.any(|(i, _)| regions.bit(i).is_none())
}

/// Returns `true` if the steps of a chord are unrolled: if they are few, and their size is known in advance.
fn writes_out(scene: &Scene) -> bool {
    /// The largest number of steps that are unrolled.
    const MOST: u32 = 16;
    let planned = !scene.rays.control.kind.rejects && scene.rays.method.kind.path == Path::Steps;
    planned && matches!(scene.rays.segment, Segment::Chord { steps } if steps <= MOST)
}

/// Returns `true` if the size of a step is needed by the pass that intersects, which holds for curved arcs.
fn keeps_taken(scene: &Scene, regions: &Regions) -> bool {
    let arcs = !scene.rays.segment.has_chords() && !regions.kinds.iter().all(RegionKind::is_line);
    arcs && !scene.objects.is_empty()
}
