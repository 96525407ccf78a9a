// Sums the length of a path, in scene units, for the depth layer.

var<storage, read_write> pixel_path_length: array<f32>;

// The depth of a pixel whose ray hit nothing: far beyond every scene, and finite, because compositing programs compute with it.
const NO_DEPTH: f32 = 1e10;

// Returns the length of an arc from a state to a position and its velocity, as if it were a part of a circle. The ratio of such an arc to
// its chord is asin(s) / s, where s² = (1 - cos a) / 2 for the angle a between its ends' directions: here to the sixth order in s.
fn arc_length(start: Phase, x: Real3, v: Real3) -> f32 {
    let s2 = 0.5 - 0.5 * dot(normalize(vec3f(start[1].xyz)), normalize(vec3f(v)));
    let ratio = 1.0 + s2 * (1.0 / 6.0 + s2 * (3.0 / 40.0 + s2 * (5.0 / 112.0)));
    return f32(length(x - start[0].xyz)) * select(1.0, ratio, s2 > 0.0);
}

fn begin_length(pixel: vec2u) {
    pixel_path_length[place_in_tile(pixel)] = 0.0;
}

fn add_length(pixel: vec2u, start: Phase, x: Real3, v: Real3) {
    pixel_path_length[place_in_tile(pixel)] += arc_length(start, x, v);
}

// Adds a segment in the schedules that integrate and terminate in different passes.
fn add_segment_length(pixel: vec2u) {
    let end = unpack_phase(end_state(pixel));
    add_length(pixel, unpack_phase(start_state(pixel)), end[0].xyz, end[1].xyz);
}
