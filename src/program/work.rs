//! How much looping one segment may be.
//!
//! Lavapipe silently stops an invocation after 65,535 loop iterations, all loops together. Every loop of the shaders counts its
//! iterations, and a pass takes no segment that might not fit any more. This module bounds what one segment needs.

use super::region_parts::ends_with_steps;
use super::{Analysis, Extent, ProgramError, RegionKind, Regions, Search, constant, own};
use crate::model::control::StepLoops;
use crate::model::method::Path;
use crate::model::{Filter, Loops, Medium};
use crate::scene::{LightGrid, Object, Precision, Scene, Segment, Shadows};

fn work_limit() -> u64 {
    constant("state/work", "WORK_LIMIT") as u64
}

/// Straight ways through all of a light's grid that one segment may be as long as.
const LINES: u64 = 2;
/// Voxels that are asked for the light at a place.
const GRID: u64 = 8 + 27 + 1;
/// A segment up to this size is walked whole: so many fit into a pass that no batch of segments is cut short.
const WHOLE: u64 = 4_000;
/// What integration and the analytic shapes may take of one invocation: the end of a path is found by following its last
/// segment again, a few times over.
/// Loop iterations that filters may take of a segment, about.
const FILTERING: u64 = 16_000;
const LARGEST: u64 = 20_000;
/// Items that a hierarchy's leaf, or a primitive, has bits for.
const MOST_ITEMS: u64 = 1 << 28;
/// Those of meshes that are kept once, in all their places, beside the word for nothing; and the nodes that a walk is at have bits for.
const MOST_ONCE: u64 = (1 << 31) - 1;

/// Bounds on the loop iterations of a segment.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Work {
    /// Iterations that a segment may need in one invocation.
    pub segment: u64,
    /// May a segment's walk over the structure be suspended and gone on with in a later pass?
    pub resumed: bool,
    /// Passes over which one segment's walk may be spread.
    pub passes_per_segment: u64,
    /// Pieces that a step is cut into, at most, where a medium filters its light.
    pub filter_pieces: u64,
}

impl Work {
    /// For this scene, and for another of the same program that takes turns with it.
    #[must_use]
    pub fn with(self, other: &Self) -> Self {
        let (segment, passes) =
            (self.segment.max(other.segment), self.passes_per_segment.max(other.passes_per_segment));
        Self { segment, passes_per_segment: passes, ..self }
    }

    /// The bounds for `scene`, whose structure was built to this extent.
    pub fn of(scene: &Scene, Analysis { regions, structure }: &Analysis, extent: Extent) -> Result<Self, ProgramError> {
        let most = if structure.once { MOST_ONCE } else { MOST_ITEMS };
        if extent.items.max(extent.places) > most {
            return Err(ProgramError::TooManyItems { items: extent.items, most });
        }
        let captures = scene.captures(None).len() as u64;
        // Neighbouring rays may be in regions of all kinds, whose loops then run one after the other.
        let media = scene.media().map(Medium::loops);
        let Loops { derivative, scale } = media.fold(scene.law.loops(), Loops::max);
        let own = own::loops(&scene.law.parts())?;
        let loops = Loops { derivative: derivative + own, scale: scale + own };
        let step = step_loops(scene, loops) + closed_loops(regions) + captures + 1;
        let asymptote = if scene.rays.asymptotic { asymptote_loops(scene.rays.precision) } else { 0 };
        let (steps, pieces) = match scene.rays.segment {
            Segment::Chord { steps } => (u64::from(steps), 1),
            Segment::Arc { .. } if regions.kinds.iter().all(RegionKind::is_line) => (1, 1),
            Segment::Arc { .. } => (1, constant("segment/curve_arc", "MAX_PIECES") as u64),
        };
        let is_listed = |(i, object): &(usize, &Object)| {
            object.travel.is_none() && (regions.bit(*i).is_some() || !structure.holds(object.solid()))
        };
        let listed = scene.objects.iter().enumerate().filter(is_listed).count() as u64;
        // Where a ray goes on from a surface its last step is taken again, a few times over.
        let touching = regions.touching.count() as u64;
        let scatter = if scene.scatters() {
            (constant("segment/path_end", "STOP_STEPS") as u64 + 2) * (step + 1) + touching
        } else {
            0
        };
        let retaken =
            u64::from(scene.rays.method.kind.evaluations) * loops.derivative + loops.scale + closed_loops(regions);
        let (filter_pieces, filter) = filtering(scene, retaken);
        // Asked for once, met in pieces, and asked for again at a path's end.
        let travels = scene.travels().count() as u64;
        let moving = travels
            * (4 + constant("segment/hit_moving", "MOVING_PIECES") as u64
                + constant("segment/path_end", "STOP_STEPS") as u64);
        // A grid is walked piece by piece.
        let place = if structure.search == Search::Grid { 1 } else { pieces } * (extent.at_once + 2);
        // Which instance a primitive is of is found by halving, wherever its surface is asked for, and where a walk goes on.
        let halvings = u64::from(u64::BITS - extent.instances.leading_zeros());
        let instances = halvings * (constant("segment/path_end", "STOP_STEPS") as u64 + 4 + touching);
        let segment = steps * step
            + pieces * (listed + 1)
            + place
            + captures
            + 2
            + asymptote
            + scatter
            + filter
            + moving
            + instances;
        if segment > LARGEST {
            let what = [
                (steps * step, "force centres"),
                (pieces * listed, "shapes in lists"),
                (moving, "objects that move"),
                (place, "triangles in the same place, or `accelerate = \"bvh\"`"),
            ];
            let (_, what) = what.into_iter().max_by_key(|(work, _)| *work).unwrap_or_default();
            return Err(ProgramError::TooMuchWork { needed: segment, limit: LARGEST, what });
        }
        // A node once, or a cell for each piece; items for each piece; and the ends of their loops.
        let walk = (pieces + 2) * (extent.places + extent.items);
        // Whatever a path ends on, its shadows are looked for in the same pass.
        let shadows = shadows(scene) * (listed + 2 + extent.at_once + 2 * (extent.places + extent.items));
        let grids = scene.lights.iter().filter(|light| light.shadows == Shadows::Grid).count() as u64;
        let whole = segment + walk + shadows + grids * GRID;
        let resumed = whole > WHOLE;
        Ok(Self {
            segment: if resumed { segment } else { whole },
            resumed,
            // Before a walk may be a segment's work, and room for as much is left behind it.
            filter_pieces,
            passes_per_segment: if resumed { 1 + walk / (work_limit() - 2 * segment) } else { 1 },
        })
    }

    /// With what a segment takes that leaves its light in the voxels on its way, of as many as there are along one line.
    pub(super) fn leaving_light(self, scene: &Scene) -> Self {
        let chords = constant("segment/leave_light", "MOST_CHORDS") as u64;
        let parts = |grid: LightGrid| 3 * u64::from(grid.voxels) * u64::from(grid.refine);
        // Where there are no lights it is what guides paths.
        let lights = scene.lights.iter().map(|light| parts(light.grid));
        let most = lights.max().unwrap_or_else(|| parts(scene.guide_grid()));
        Self { segment: self.segment + (2 * chords + LINES * most).min(LARGEST), ..self }
    }

    /// Segments that one pass is sure to complete, of `wanted`.
    #[must_use]
    pub fn segments_per_pass(&self, wanted: u32) -> u32 {
        let sure = (work_limit() / (self.segment + 1)).max(1);
        wanted.min(u32::try_from(sure).unwrap_or(u32::MAX)).max(1)
    }
}

/// Lines to lights from a surface, with those on behind what lets light through.
fn shadows(scene: &Scene) -> u64 {
    let part = if scene.splits() { "surface/shadow/clear" } else { "surface/shadow/opaque" };
    scene.lines().count() as u64 * constant(part, "CROSSINGS") as u64
}

/// Pieces that a step is cut into for a filter, at most, and the loop iterations of all, if a place on a step takes so many: of a piece
/// six evaluations and its middle, and of some the search for a jump.
fn filtering(scene: &Scene, place: u64) -> (u64, u64) {
    let Some(own) = scene.filters().map(Filter::loops).max() else { return (0, 0) };
    let piece = 6 * (own + place + 1) + place + 1;
    let jump = constant("filter/jumping", "JUMP_LOOKS") as u64 * (own + place + 1);
    let jumps = if scene.filters().any(Filter::jumps) { FILTERING / 2 / jump } else { 0 };
    let pieces = ((FILTERING - jumps * jump) / piece).clamp(16, 1024);
    (pieces, pieces * piece + jumps * jump)
}

/// Iterations of the steps of closed forms.
fn closed_loops(regions: &Regions) -> u64 {
    let forms = regions.kinds.iter().filter_map(|kind| kind.motion.closed_form());
    regions.obstacles.len() as u64 + forms.map(|form| form.loops).max().unwrap_or(0)
}

/// Iterations from the bounding sphere to infinity.
fn asymptote_loops(precision: Precision) -> u64 {
    let part = if precision == Precision::Double { "real/f64" } else { "real/f32" };
    constant(part, "ASYMPTOTE_STEPS") as u64 + 16
}

fn step_loops(scene: &Scene, Loops { derivative, scale }: Loops) -> u64 {
    let (method, control) = (scene.rays.method.kind, scene.rays.control.kind);
    if method.path == Path::Orbit {
        let separated = ["motion/separated_open"; 2];
        let [steps, cuts] = if ends_with_steps(scene) { separated } else { ["motion/orbit_open", "motion/edge_bound"] };
        return if scene.needs_arcs() { 0 } else { (constant(steps, "STEPS") + constant(cuts, "CUTS")) as u64 };
    }
    let tries = control.tries.map_or(1, |part| constant(part, "MAX_TRIES") as u64);
    (control.loops)(&StepLoops { evaluations: method.evaluations.into(), derivative, scale, tries })
}
