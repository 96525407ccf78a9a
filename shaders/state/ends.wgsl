// Stores the end of each path of a sample, from which an image is shaded again without following the path.

struct StoredEnd {
    // The status code; ALIVE if the pixel has no path in this round.
    status: u32,
    primitive: u32,
    // The end that the pixel's corners share; 0 if they do not share one.
    shared_end: u32,
    // The set of regions.
    inside: u32,
    // The choices at splits.
    branch: u32,
    x: vec3f,
    v: vec3f,
    tau: f32,
    // The sides of the pixel.
    across: vec3f,
    down: vec3f,
    throughput: vec3f,
    // The growth of momentum along the path, if it is not constant.
    stretch: f32,
}

// The positions of these values in the buffer.
const END_STATUS: u32 = 0u;
const END_PRIMITIVE: u32 = 1u;
const END_SHARED: u32 = 2u;
const END_INSIDE: u32 = 3u;
const END_BRANCH: u32 = 4u;
const END_X: u32 = 5u;
const END_V: u32 = 8u;
const END_TAU: u32 = 11u;
// The position on the surface, for other programs.
const END_UV: u32 = 12u;
const END_ACROSS: u32 = 14u;
const END_DOWN: u32 = 17u;
const END_THROUGHPUT: u32 = 20u;
const END_STRETCH: u32 = 23u;
const END_VALUES: u32 = 24u;

// The bits of the first value of every pixel, then those of the second, and so on. Zeros before every round.
var<storage, read_write> stored_ends: array<u32>;

// Returns the index of a value of a pixel.
fn end_index(pixel: vec2u, value: u32) -> u32 {
    return value * frame.size.x * frame.size.y + place_in_tile(pixel);
}

fn end_number(pixel: vec2u, value: u32) -> f32 {
    return bitcast<f32>(stored_ends[end_index(pixel, value)]);
}

fn end_vector(pixel: vec2u, value: u32) -> vec3f {
    return vec3f(end_number(pixel, value), end_number(pixel, value + 1u), end_number(pixel, value + 2u));
}

fn put_end_number(pixel: vec2u, value: u32, number: f32) {
    stored_ends[end_index(pixel, value)] = bitcast<u32>(number);
}

fn put_end_vector(pixel: vec2u, value: u32, vector: vec3f) {
    put_end_number(pixel, value, vector.x);
    put_end_number(pixel, value + 1u, vector.y);
    put_end_number(pixel, value + 2u, vector.z);
}

fn load_end(pixel: vec2u) -> StoredEnd {
    return StoredEnd(
        stored_ends[end_index(pixel, END_STATUS)],
        stored_ends[end_index(pixel, END_PRIMITIVE)],
        stored_ends[end_index(pixel, END_SHARED)],
        stored_ends[end_index(pixel, END_INSIDE)],
        stored_ends[end_index(pixel, END_BRANCH)],
        end_vector(pixel, END_X),
        end_vector(pixel, END_V),
        end_number(pixel, END_TAU),
        end_vector(pixel, END_ACROSS),
        end_vector(pixel, END_DOWN),
        end_vector(pixel, END_THROUGHPUT),
        end_number(pixel, END_STRETCH),
    );
}

fn store_end(pixel: vec2u, code: u32, primitive: u32, end: PathPoint) {
    stored_ends[end_index(pixel, END_STATUS)] = code;
    stored_ends[end_index(pixel, END_PRIMITIVE)] = select(0u, primitive, code == HIT);
    let bundle = pixel_bundle(pixel);
    stored_ends[end_index(pixel, END_SHARED)] = bundle.end;
    stored_ends[end_index(pixel, END_INSIDE)] = region_bits();
    if ENUMERATES {
        stored_ends[end_index(pixel, END_BRANCH)] = branch_code;
    }
    put_end_vector(pixel, END_X, vec3f(end.x));
    put_end_vector(pixel, END_V, vec3f(end.v));
    put_end_number(pixel, END_TAU, f32(end.tau));
    let uv = select(vec2f(0.0), place_seen.xy, code == HIT);
    put_end_number(pixel, END_UV, uv.x);
    put_end_number(pixel, END_UV + 1u, uv.y);
    put_end_vector(pixel, END_ACROSS, bundle.across);
    put_end_vector(pixel, END_DOWN, bundle.down);
    put_end_vector(pixel, END_THROUGHPUT, kept_throughput());
    if FOLLOWS_SHIFT {
        put_end_number(pixel, END_STRETCH, kept_stretch());
    }
}
