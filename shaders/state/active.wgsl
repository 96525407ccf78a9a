// Which pixel an invocation works on, and the arguments of indirect dispatches.

// Pixels of one workgroup.
const GROUP: u32 = 64u;
// How many of them lie side by side. Squares end together, and long rows are read ahead: which counts for more is known of the
// device, so that the host may set another number.
override GROUP_WIDTH: u32 = 8u;

// Pixels that one invocation of the pass `whole` follows, one below the other: the more there are, the less what a group does once
// costs each of them, and the fewer groups there are. The host sets another number for processors.
override LANE_PIXELS: u32 = 1u;

// Where an invocation is in its dispatch. Not how many groups there are: naga's HLSL takes that from the driver in the entry point alone,
// and what is handed on is the group's id.
struct Invocation {
    @builtin(workgroup_id) group: vec3u,
    @builtin(local_invocation_index) lane: u32,
}

struct Place {
    // Always one of the tile's, so that nothing outside it is ever read.
    pixel: vec2u,
    // Invocations past the end of the work have no pixel of their own.
    valid: bool,
}

struct ActiveList {
    x: atomic<u32>,
    y: atomic<u32>,
    z: atomic<u32>,
    count: atomic<u32>,
}

// A pixel in a pass over active rays, and the status of its ray.
struct ActiveRay {
    pixel: vec2u,
    valid: bool,
    alive: bool,
    word: u32,
    code: u32,
    index: u32,
}

fn active_ray(own: Invocation) -> ActiveRay {
    let spot = active_pixel(own);
    let word = load_status(spot.pixel);
    let code = status_code(word);
    load_region(spot.pixel);
    return ActiveRay(spot.pixel, spot.valid, spot.valid && code == ALIVE, word, code, status_index(word));
}

// Width and height of a workgroup.
fn group_extent() -> vec2u {
    return vec2u(GROUP_WIDTH, GROUP / GROUP_WIDTH);
}

// Where an invocation would stand, if each had one pixel, for the k-th of several.
fn lane_invocation(own: Invocation, each: u32, k: u32) -> Invocation {
    var at = own;
    at.group.y = own.group.y * each + k;
    return at;
}

// Which rays go on is told by keep_active(alive, pixel, lane) in state/active/. Every lane calls it, and it is a barrier
// of the group: what its lanes have tallied before is complete behind it.

// Of dispatches over the whole grid of pixels.
fn grid_pixel(own: Invocation) -> Place {
    let pixel = own.group.xy * group_extent() + vec2u(own.lane % GROUP_WIDTH, own.lane / GROUP_WIDTH);
    let valid = all(pixel < frame.size);
    return Place(select(vec2u(0u), pixel, valid), valid);
}
