// The state of a ray, one segment of its path, what it hit, and how it can end.

// A ray under way. `phase` is the point in ray phase space (W04 §3.1), in the scene's coordinates.
struct Ray {
    phase: Phase,
    // The path's parameter so far, and what its last digit does not hold of it.
    tau: Real,
    rest: Real,
    // What the control remembers from step to step.
    memory: Memory,
    // The size of the step taken last.
    taken: Real,
    // Whole segments so far.
    index: u32,
    steps: u32,
    rejected: u32,
    status: u32,
}

// How fast a place moves, of a state's velocity.
fn path_velocity(v: Real3) -> Real3 {
    if BY_LENGTH {
        return normalize(v);
    }
    return v;
}

// One segment: positions and velocities at its ends, and its extent in tau.
struct Segment {
    x0: Real3,
    v0: Real3,
    x1: Real3,
    v1: Real3,
    h: Real,
}

// A segment that was followed without asking whether the path is over.
struct Quick {
    segment: Segment,
    // False where the path may have been over before the segment's end.
    sure: bool,
}

// The first thing met along a segment: a fraction t in [0, 1) of it, and a primitive or NOTHING.
struct Hit {
    t: Real,
    primitive: u32,
}

// A primitive is its shape's kind in the upper four bits, and its place in that kind's list.
const PRIMITIVE_INDEX: u32 = 0x0fffffffu;
const NOTHING: u32 = 0xffffffffu;

// Hits that rounding puts just outside a piece still count, so that none falls between two pieces.
const OVERLAP: Real = 1e-5;

// Status codes.
const ALIVE: u32 = 0u;
const HIT: u32 = 1u;
// Left the bounding sphere outwards.
const ESCAPED: u32 = 2u;
const CAPTURED: u32 = 3u;
// Reached rays.length.
const ENDED: u32 = 4u;
// Used rays.max_segments.
const EXHAUSTED: u32 = 5u;
// The step fell under what moves the ray.
const STALLED: u32 = 6u;
// Not finite any more.
const FAILED: u32 = 7u;
// Never entered the bounding sphere: escaped where it started.
const MISSED: u32 = 8u;
// There is no ray: the picture shows nothing there.
const OUTSIDE: u32 = 9u;
// Would have split once more than rays.branches allows, or weighs nothing any more.
const CUT: u32 = 10u;
// All of its pixel's branches have been followed.
const RESTING: u32 = 11u;
// A walk was longer than the passes that were recorded for it: the tile is rendered again, with all that it may need.
const UNFINISHED: u32 = 12u;

// Not a ray's end, but counted beside them: a place on a surface that no path from a light leads to.
const UNLIT: u32 = 13u;
// Nor this: light that a voxel had no room for.
const LOST: u32 = 14u;
// Nor this: a stretch of a path whose filter could not be had to its tolerance, or is none: below 0, or above 1.
const UNFILTERED: u32 = 15u;
// Nor this: a segment that needs more loop iterations than the device runs in one pass.
const OVERRUN: u32 = 16u;

// Did the path end on a surface?
fn ends_on_surface(code: u32) -> bool {
    return code == HIT || code == CUT;
}

// A pixel's status in a word: the code, the slot in which the ray's state lies, and the index of its segment.
fn status_word(code: u32, slot: u32, index: u32) -> u32 {
    return code | (slot << 4u) | (index << 6u);
}

fn status_code(word: u32) -> u32 {
    return word & 15u;
}

fn status_slot(word: u32) -> u32 {
    return (word >> 4u) & 3u;
}

fn status_index(word: u32) -> u32 {
    return word >> 6u;
}

fn finite_phase(p: Phase) -> bool {
    return finite(p[0].xyz) && finite(p[1].xyz);
}

// The ray after a step to `end`, over so much tau.
fn after_step(ray: Ray, end: Phase, passed: Real) -> Ray {
    var next = later(ray, passed);
    next.phase = opaque_phase(end);
    next.taken = opaque(passed);
    next.steps += 1u;
    return next;
}

// The ray after a step. Before a place where its law has no finite value tries that reach it are rejected (`lost`), however short:
// a ray that then does not move is not stalled for want of digits, but has failed. Its place stays, its velocity is none any more.
fn failed_if(lost: bool, before: Ray, after: Ray) -> Ray {
    var next = after;
    if lost && finite_phase(before.phase) && all(next.phase[0].xyz == before.phase[0].xyz) {
        next.phase[1] = next.phase[1] * infinite();
    }
    return next;
}
