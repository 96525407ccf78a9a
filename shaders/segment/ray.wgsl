// The state of a ray, one segment of its path, its hit, and its status codes.

// An active ray. `phase` is the point in ray phase space (W04 §3.1), in the scene's coordinates.
struct Ray {
    phase: Phase,
    // The parameter of the path so far, and the part of it below its last digit.
    tau: Real,
    rest: Real,
    // The memory of the step control.
    memory: Memory,
    // The size of the last step.
    taken: Real,
    // The number of whole segments so far.
    index: u32,
    steps: u32,
    rejected: u32,
    status: u32,
}

// Returns the velocity of the position, from the velocity of a state.
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

// A segment that was followed without testing whether the path is over.
struct Quick {
    segment: Segment,
    // False if the path may have been over before the end of the segment.
    sure: bool,
}

// The first hit along a segment: a fraction t in [0, 1) of it, and a primitive or NOTHING.
struct Hit {
    t: Real,
    primitive: u32,
}

// A primitive is the kind of its shape in the upper four bits, and its index in the list of that kind.
const PRIMITIVE_INDEX: u32 = 0x0fffffffu;
const NOTHING: u32 = 0xffffffffu;

// Hits that rounding puts just outside a piece still count, so that none is lost between two pieces.
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
// The step became too small to move the ray.
const STALLED: u32 = 6u;
// The state is not finite.
const FAILED: u32 = 7u;
// Never entered the bounding sphere: escaped where it started.
const MISSED: u32 = 8u;
// There is no ray: the image is empty there.
const OUTSIDE: u32 = 9u;
// Would have split more often than rays.branches allows, or has a negligible throughput.
const CUT: u32 = 10u;
// All branches of its pixel have been followed.
const RESTING: u32 = 11u;
// A walk was longer than the passes recorded for it: the tile is rendered again, with all passes that it may need.
const UNFINISHED: u32 = 12u;

// Counted like a status, but not the end of a ray: a position on a surface that no path from a light reaches.
const UNLIT: u32 = 13u;
// Also only counted: light that a voxel had no room for.
const LOST: u32 = 14u;
// Also only counted: a segment that needs more loop iterations than the device runs in one pass.
const OVERRUN: u32 = 15u;
// Also only counted: a path through matter that is negative, not a number or faster than light.
const UNDEFINED: u32 = 16u;
// Also only counted: a stretch of a path on which the light or the absorption of matter did not converge to the tolerance.
const UNSETTLED: u32 = 17u;

// Returns `true` if the path ended on a surface.
fn ends_on_surface(code: u32) -> bool {
    return code == HIT || code == CUT;
}

// Packs a pixel's status into a word: the code, the slot that holds the ray's state, and the index of its segment.
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

// Returns the ray after a step to `end`, over `passed` of tau.
fn after_step(ray: Ray, end: Phase, passed: Real) -> Ray {
    var next = later(ray, passed);
    next.phase = opaque_phase(end);
    next.taken = opaque(passed);
    next.steps += 1u;
    return next;
}

// Returns the ray after a step. Near a position where its law has no finite value, tries that reach it are rejected (`lost`), however
// short: a ray that then does not move has failed, instead of being stalled for lack of digits. Its position stays, and its velocity
// becomes not a number.
fn failed_if(lost: bool, before: Ray, after: Ray) -> Ray {
    var next = after;
    if lost && finite_phase(before.phase) && all(next.phase[0].xyz == before.phase[0].xyz) {
        next.phase[1] = next.phase[1] * infinite();
    }
    return next;
}
