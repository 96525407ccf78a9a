// Maps invocations to pixels, and holds the arguments of indirect dispatches.

// The number of pixels in one workgroup.
const GROUP: u32 = 64u;
// The width of a workgroup in pixels. Rays of a square end together, and long rows are read ahead. The better choice depends on the device,
// so that the host may set another number.
override GROUP_WIDTH: u32 = 8u;

// The number of pixels that one invocation of the pass `whole` follows: with more pixels, the setup of a group costs each of them less, and
// there are fewer groups. The host sets another number for CPUs.
override LANE_PIXELS: u32 = 1u;

// The position of an invocation in its dispatch. It excludes the number of groups: naga's HLSL takes that from the driver in the entry
// point alone, and passes the group's id on instead.
struct Invocation {
    @builtin(workgroup_id) group: vec3u,
    @builtin(local_invocation_index) lane: u32,
}

struct Place {
    // Always a pixel of the tile, so that nothing outside it is ever read.
    pixel: vec2u,
    // False for invocations past the end of the work, which have no pixel.
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

// Returns the width and height of a workgroup.
fn group_extent() -> vec2u {
    return vec2u(GROUP_WIDTH, GROUP / GROUP_WIDTH);
}

// Returns the invocation of the k-th of several pixels, as if each pixel had one. The pixels are spread over the height of the tile, because
// drivers for CPUs give each core one block of groups: a sky above a floor would otherwise keep one core waiting for another.
fn lane_invocation(own: Invocation, each: u32, k: u32) -> Invocation {
    let rows = group_extent().y * each;
    var at = own;
    at.group.y += k * ((frame.size.y + rows - 1u) / rows);
    return at;
}

// keep_active(alive, pixel, lane) in state/active/ records which rays continue. Every lane calls it, and it is a barrier of the group: the
// tallies of its lanes are complete after it.

// Returns the pixel in dispatches over the whole grid of pixels.
fn grid_pixel(own: Invocation) -> Place {
    let pixel = own.group.xy * group_extent() + vec2u(own.lane % GROUP_WIDTH, own.lane / GROUP_WIDTH);
    let valid = all(pixel < frame.size);
    return Place(select(vec2u(0u), pixel, valid), valid);
}
