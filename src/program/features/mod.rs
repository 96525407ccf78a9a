//! What a scene asks of its program, found once: plain answers, from which the plan follows.
//!
//! *Length.* Over 300 lines, because it is a list, with a field and a line for each answer.

mod constants;

use glam::DVec3;

use super::regions::{RegionKind, Regions};
use super::{Analysis, Choice, DeviceProfile, Layer, Masks, Pass, Purpose, Schedule};
use crate::model::method::Path;
use crate::model::{Capture, Filter, StereoLayout};
use crate::scene::{Animation, Branches, Light, Precision, Scene, Segment, Shadows, Sky, Tonemap};

/// Everything about a scene and what it is rendered for that decides which parts its program has, and which passes run it.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
#[expect(clippy::struct_excessive_bools, reason = "each answers a question of its own")]
pub struct Features {
    /// Where rays come from and what becomes of them.
    pub purpose: Purpose,
    /// How passes are cut: as asked for, or `Fused` if the scene's paths do not fit into one pass.
    pub schedule: Schedule,
    /// How ended rays are skipped.
    pub masks: Masks,
    /// What the device is like.
    pub device: DeviceProfile,
    /// Layers to keep, each once.
    pub layers: Vec<Layer>,
    /// The numbers of rays.
    pub precision: Precision,
    /// Rounds of a sample, at most, in each of which every pixel follows one more path of its tree: the leaves of a full one.
    pub rounds: u32,
    /// Slots of the state: `paper` keeps a chord's start while two more alternate under its steps.
    pub slots: usize,

    /// The scene has objects.
    pub has_objects: bool,
    /// Rays go on from some surface.
    pub scatters: bool,
    /// Some surface both reflects and transmits.
    pub splits: bool,
    /// Some surface shows what is behind it.
    pub is_translucent: bool,
    /// Some clear object has a rough surface.
    pub has_rough_glass: bool,
    /// Objects have insides, or closed mirrors two sides.
    pub has_regions: bool,
    /// Rays go on from some mesh with two sides.
    pub has_sided_mesh: bool,
    /// Objects lie on each other.
    pub touches: bool,
    /// Some medium has another index for each wavelength.
    pub disperses: bool,
    /// Media absorb light of its rays.
    pub filters: bool,
    /// Some medium absorbs light by a texture that jumps.
    pub filters_jump: bool,
    /// Some medium adds light to rays.
    pub sees_glow: bool,

    /// Light goes from surface to surface.
    pub follows_paths: bool,
    /// Its paths are in pieces, which are told where they left a surface.
    pub in_pieces: bool,
    /// Paths aim at something bright.
    pub aims: bool,
    /// Samples are cut off at some radiance.
    pub clamps: bool,
    /// A path is of one wavelength.
    pub draws_wavelength: bool,
    /// Some surface shows a light.
    pub is_lit: bool,
    /// Some lights fall off with the square of the distance.
    pub falls: bool,
    /// Some lights with a grid are as bright as their paths are many.
    pub grids_fall: bool,
    /// All of them are.
    pub grids_all_fall: bool,
    /// Paths to lights are found by shooting.
    pub shoots: bool,
    /// Ambient light is occluded where a surface shows it.
    pub is_occluded: bool,
    /// It is occluded by what lies on the law's paths, rather than on straight lines.
    pub occludes_along_law: bool,
    /// Shadows are cast along straight lines.
    pub follows_lines: bool,
    /// Light is looked for from surfaces, along lines or paths that begin there.
    pub looks_from_surfaces: bool,
    /// All lights cast shadows along straight lines.
    pub all_cast: bool,
    /// Clear objects shut out light that comes in straight lines.
    pub shuts_out: bool,
    /// Something absorbs part of the light that comes in straight lines to a picture's surfaces.
    pub weakens_lines: bool,

    /// Rays end after a length.
    pub is_limited: bool,
    /// The last digits of τ are kept apart from its sum.
    pub compensates_tau: bool,
    /// Something captures rays.
    pub captures: bool,
    /// Rays end where a formula of a line element says.
    pub captures_by_formula: bool,
    /// Orbits of light lie within the place where rays are captured: those that turn there are not.
    pub is_extreme: bool,
    /// The bounding sphere is left for infinity.
    pub is_asymptotic: bool,
    /// Where a path is between its ends is asked for.
    pub needs_arcs: bool,
    /// Rays follow an orbit in closed form.
    pub on_orbit: bool,
    /// Orbits stay in a plane through the law's center.
    pub is_plane: bool,
    /// The bounding sphere is about the orbit's center, in every frame.
    pub is_about_center: bool,
    /// The last step of a path ends where the path does.
    pub ends_with_steps: bool,
    /// That last step is kept for the path's end.
    pub keeps_last: bool,
    /// The part that ends rays from below a horizon, if the camera may be there.
    pub below_part: Option<&'static str>,
    /// States carry the time of the ray.
    pub carries_time: bool,
    /// τ is the path's length, whatever the velocity.
    pub by_length: bool,
    /// The curve that all rays follow has the axes of the camera.
    pub turns_with_camera: bool,
    /// Some object moves.
    pub travels: bool,
    /// The law is a wormhole's.
    pub has_throat: bool,
    /// All paths are whole lines, which begin where a ray does.
    pub joins_whole: bool,

    /// The sky beyond a wormhole is another one.
    pub has_two_skies: bool,
    /// The sky is transparent.
    pub sees_through: bool,
    /// Pictures are shown by surfaces or the sky.
    pub has_images: bool,
    /// Some mesh has colors at its corners.
    pub has_vertex_colors: bool,
    /// Pixels may show nothing.
    pub is_transparent: bool,
    /// Rays choose between the branches at a surface one after the other.
    pub enumerates: bool,
    /// The picture is two views, side by side or one above the other.
    pub views: Option<StereoLayout>,
    /// Pixels take as many samples as they need.
    pub adapts: bool,
    /// Adaptive sampling compares pixels as a filmic tone map shows them.
    pub is_filmic: bool,
    /// The size of a step is kept for the pass that intersects.
    pub keeps_taken: bool,
    /// More of a ray than X and V is kept between passes.
    pub keeps_w: bool,
    /// A ray cannot meet again the flat surface that it goes on from.
    pub keeps_last_hit: bool,
    /// Some step leads through a whole region.
    pub has_leaps: bool,
    /// A walk through the structure may be suspended where a pass has no more room.
    pub suspends: bool,
    /// The structure's items are those of a single kind, in that kind's own order.
    pub items_in_order: bool,
    /// Segments are chords over several steps.
    pub has_chords: bool,
    /// The steps of a chord are written out one by one.
    pub writes_chords_out: bool,
    /// Steps are tried again when their error is too large.
    pub rejects: bool,
    /// Steps whose error is too large are kept.
    pub keeps_errors: bool,
    /// The objects of some kinds are in a structure.
    pub has_structure: bool,
    /// Some surface has a highlight on paths.
    pub is_glossy: bool,
    /// What pixels see of pictures and patterns is known.
    pub keeps_footprints: bool,
    /// Light is as bright as its shift makes it.
    pub beams: bool,
    /// Colors are taken for those of black bodies.
    pub shifts_hues: bool,
    /// The shift of light is asked for, and has an answer.
    pub knows_shift: bool,
    /// The shift is followed along each path, because nothing conserves it.
    pub follows_shift: bool,
    /// Light is told apart by the crossing of translucent surfaces that it comes from.
    pub keeps_orders: bool,
}

impl Features {
    /// Finds those of `scene`, rendered as `choice` says.
    #[must_use]
    pub fn of(scene: &Scene, choice: &Choice, Analysis { regions, structure }: &Analysis) -> Self {
        let Choice { purpose, masks, layers, device, .. } = choice.clone();
        let is_picture = purpose == Purpose::Picture;
        let facts = scene.law.facts();
        let rounds = rounds(scene, is_picture);
        let shoots = scene.has_shadows(Shadows::Shooting);
        // A path is one pass in pictures that follow one path a sample, and whose state is not to be rounded between segments.
        let fits = is_picture && rounds == 1 && scene.rays.precision != Precision::Half && !shoots;
        let schedule = if choice.schedule == Schedule::Whole && !fits { Schedule::Fused } else { choice.schedule };
        let camera = scene.camera.as_ref();
        let grids = || scene.lights.iter().filter(|light| light.shadows == Shadows::Grid);
        let beams = is_picture && camera.is_some_and(|camera| camera.shift);
        let knows_shift = beams || is_picture && layers.contains(&Layer::Shift) && scene.has_frequencies();
        let follows_paths = is_picture && scene.rays.paths.is_some();
        let joins_whole = regions.kinds.iter().all(|kind| joins_whole(scene, kind));
        let ends_with_steps = ends_with_steps(scene);
        let (is_occluded, follows_lines) = (scene.is_occluded(), scene.lines().next().is_some());
        Self {
            purpose,
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
            filters: (is_picture || purpose.leaves_light()) && scene.filters().next().is_some(),
            filters_jump: scene.filters().any(Filter::jumps),
            sees_glow: is_picture && scene.filters().any(|filter| filter.glow != DVec3::ZERO),

            follows_paths,
            in_pieces: follows_paths && !joins_whole,
            aims: follows_paths && !scene.aims().is_empty(),
            clamps: follows_paths && scene.output.clamp.is_some(),
            draws_wavelength: scene.disperses() && (follows_paths || purpose == Purpose::Caustics),
            is_lit: scene.is_lit(),
            falls: scene.lights.iter().any(|light| light.falls),
            grids_fall: grids().any(Light::falls_in_grid),
            grids_all_fall: grids().all(Light::falls_in_grid),
            shoots: shoots || purpose == Purpose::Lit,
            is_occluded,
            occludes_along_law: is_occluded && scene.occlusion.is_some_and(|occlusion| occlusion.along_law),
            follows_lines,
            looks_from_surfaces: follows_lines || is_occluded,
            all_cast: scene.lights.iter().all(|light| light.shadows == Shadows::Straight),
            shuts_out: scene.shuts_out(),
            weakens_lines: is_picture && scene.weakens_lines(),

            is_limited: scene.rays.length.is_some(),
            compensates_tau: compensates_tau(scene),
            captures: !scene.captures(None).is_empty(),
            captures_by_formula: facts.line_element().is_some_and(|element| element.graph().4.is_some()),
            is_extreme: facts.turns_before_capture,
            is_asymptotic: scene.rays.asymptotic,
            needs_arcs: scene.needs_arcs(),
            on_orbit: scene.rays.method.kind.path == Path::Orbit,
            is_plane: facts.orbit.is_some_and(|orbit| orbit.is_plane()),
            is_about_center: is_about_center(scene),
            ends_with_steps,
            keeps_last: ends_with_steps && !scene.rays.segment.has_chords() && schedule == Schedule::Whole,
            below_part: below_part(scene, purpose, facts.below),
            carries_time: facts.carries_time,
            by_length: facts.by_length,
            turns_with_camera: facts.curve().is_some_and(|curve| curve.turned.is_some()),
            travels: scene.travels().next().is_some(),
            has_throat: facts.throat.is_some(),
            joins_whole,

            has_two_skies: is_picture && scene.beyond.is_some(),
            sees_through: is_picture && scene.sky == Sky::Transparent,
            has_images: !scene.pictures.is_empty(),
            has_vertex_colors: scene.uses_vertex_colors(),
            is_transparent: scene.is_transparent(),
            enumerates: is_picture && scene.scatters() && matches!(scene.rays.branches, Branches::Enumerated(_)),
            views: camera.and_then(|camera| Some(camera.stereo?.layout)),
            adapts: is_picture && scene.image.adaptive.is_some(),
            is_filmic: scene.output.tonemap == Tonemap::Filmic,
            keeps_errors: scene.rays.control.kind.keeps_errors,
            has_structure: !structure.solids.is_empty(),
            is_glossy: scene.used_materials().any(|material| material.surface.facts().is_glossy),
            keeps_footprints: is_picture && scene.has_footprints(),
            beams,
            shifts_hues: beams && camera.is_some_and(|camera| camera.hues),
            knows_shift,
            follows_shift: knows_shift && facts.changes_with_time,
            keeps_orders: is_picture && layers.contains(&Layer::Orders) && scene.has_orders(),
            layers,
        }
    }

    /// Is it a picture?
    #[must_use]
    pub fn is_picture(&self) -> bool {
        self.purpose == Purpose::Picture
    }

    /// Do later rounds and samples run over no more than the pixels that have a path left, or want more samples?
    #[must_use]
    pub fn lists_open(&self) -> bool {
        self.masks != Masks::Off && (self.rounds > 1 || self.adapts)
    }

    /// Columns and rows that a tile has beyond its pixels: the last ones' corners are those of the next.
    #[must_use]
    pub fn margin(&self) -> u32 {
        (self.adapts || self.keeps_footprints).into()
    }

    /// Does the program keep each ray's step counts?
    #[must_use]
    pub fn keeps_counts(&self) -> bool {
        matches!(self.purpose, Purpose::Trace | Purpose::Pixels) || self.layers.contains(&Layer::Steps)
    }

    /// The passes, in the order in which they first run.
    #[must_use]
    pub fn passes(&self) -> Vec<Pass> {
        let mut passes = match (self.purpose, self.schedule) {
            (Purpose::Bare, _) => return vec![Pass::Setup, Pass::Bare],
            (Purpose::Lit, _) => return vec![Pass::Setup, Pass::Shots],
            (_, Schedule::Whole) => vec![Pass::Whole],
            (_, Schedule::Fused) => vec![Pass::Setup, Pass::Advance],
            (_, Schedule::Segment) => vec![Pass::Setup, Pass::Integrate],
            (_, Schedule::Paper) => vec![Pass::Setup, Pass::SingleStep],
        };
        if matches!(self.schedule, Schedule::Segment | Schedule::Paper) {
            passes.extend(self.has_objects.then_some(Pass::Intersect));
            passes.push(Pass::Terminate);
            passes.extend(self.scatters.then_some(Pass::Scatter));
        }
        if self.schedule != Schedule::Whole {
            passes.push(if self.is_picture() { Pass::Shade } else { Pass::Record });
        }
        passes.extend(self.adapts.then_some(Pass::Refine));
        passes
    }

    /// Does something ask how far along its path a ray is?
    #[must_use]
    pub fn asks_tau(&self) -> bool {
        self.needs_arcs || !matches!(self.purpose, Purpose::Picture | Purpose::Bare)
    }
}

/// Returns how many rounds a sample has at most: one for each leaf of the full tree of a path.
fn rounds(scene: &Scene, is_picture: bool) -> u32 {
    match scene.rays.branches {
        Branches::Enumerated(depth) if is_picture && scene.branches() => 1 << depth,
        _ => 1,
    }
}

/// Returns how many slots the state has: `paper` keeps the start of a chord beside those that its steps alternate between.
fn slots(scene: &Scene, schedule: Schedule) -> usize {
    let has_many_steps = matches!(scene.rays.segment, Segment::Chord { steps } if steps > 1);
    if schedule == Schedule::Paper && has_many_steps { 3 } else { 2 }
}

/// The part that ends light from below a horizon, unless it is known that the camera is above: a film has one program for all places that its
/// camera comes to.
fn below_part(scene: &Scene, purpose: Purpose, below: Option<(&'static str, Capture)>) -> Option<&'static str> {
    let moves = |animation: &Animation| {
        animation.keys.iter().any(|key| ["camera.position", "camera.proper_time"].contains(&&**key))
    };
    let is_anywhere = purpose.is_given() || scene.animation.as_ref().is_some_and(moves);
    let eye = scene.camera.as_ref().filter(|_| !is_anywhere).map(|camera| camera.position);
    let (part, horizon) = below?;
    eye.is_none_or(|eye| horizon.distance(eye) < 0.0).then_some(part)
}

/// Are τ's last digits kept apart from its sum?
fn compensates_tau(scene: &Scene) -> bool {
    scene.rays.length.is_some() && scene.rays.precision != Precision::Double
}

/// Are a kind of region's paths whole lines, which begin where a ray does?
pub(super) fn joins_whole(scene: &Scene, kind: &RegionKind) -> bool {
    kind.motion.closed_form().is_some_and(|form| form.is_line) && !scene.rays.segment.has_chords()
}

/// Does the last step of a path end where the path does? So where orbits separate and there is nothing to hit.
pub(super) fn ends_with_steps(scene: &Scene) -> bool {
    let separates = scene.law.facts().orbit.is_some_and(|orbit| !orbit.is_plane());
    let on_orbit = scene.rays.method.kind.path == Path::Orbit;
    on_orbit && separates && !scene.needs_arcs() && is_about_center(scene)
}

/// Is the bounding sphere about the orbits' center, in every frame?
fn is_about_center(scene: &Scene) -> bool {
    let moves = |key: &String| key.starts_with("law.") || key.starts_with("rays.bounding_sphere");
    let is_still = scene.animation.as_ref().is_none_or(|animation| !animation.keys.iter().any(moves));
    is_still && scene.law.facts().orbit.is_some_and(|orbit| orbit.center == scene.rays.bound.center)
}

/// May rays go on from flat surfaces, of which they are on neither side?
fn is_flat(scene: &Scene, regions: &Regions) -> bool {
    let mut continuing = scene.objects.iter().enumerate().filter(|(_, object)| scene.continues_from(object));
    scene.has_translucent() || continuing.any(|(i, _)| regions.bit(i).is_none())
}

/// Are a chord's steps written out? There are few, and their size is known before they are taken.
fn writes_out(scene: &Scene) -> bool {
    /// Steps up to which they are.
    const MOST: u32 = 16;
    let planned = !scene.rays.control.kind.rejects && scene.rays.method.kind.path == Path::Steps;
    planned && matches!(scene.rays.segment, Segment::Chord { steps } if steps <= MOST)
}

/// Arcs that are not straight need their step's size in the pass that intersects them.
fn keeps_taken(scene: &Scene, regions: &Regions) -> bool {
    let arcs = !scene.rays.segment.has_chords() && !regions.kinds.iter().all(RegionKind::is_line);
    arcs && !scene.objects.is_empty()
}
