// Layers of a ray's end, besides its colour: of a pixel's first sample, for positions and ids have no average.

var<storage, read_write> pixel_layer_depth: array<f32>;
var<storage, read_write> pixel_layer_normal: array<vec3f>;
var<storage, read_write> pixel_layer_object: array<u32>;
var<storage, read_write> pixel_layer_position: array<vec3f>;
var<storage, read_write> pixel_layer_shift: array<f32>;
var<storage, read_write> pixel_layer_status: array<u32>;
var<storage, read_write> pixel_layer_steps: array<u32>;
var<storage, read_write> pixel_layer_way: array<vec3f>;

// How far along its path the ray ended, in segments: whole ones and a fraction (W04 §3.3's depth).
fn keep_depth(pixel: vec2u, ray: Ray, seen: Seen) {
    pixel_layer_depth[place_in_tile(pixel)] = f32(ray.index) + f32(seen.end.fraction);
}

// The surface's normal, towards the viewer; 0 where nothing was hit.
fn keep_normal(pixel: vec2u, ray: Ray, seen: Seen) {
    pixel_layer_normal[place_in_tile(pixel)] = seen.normal;
}

// The object that was hit: its place in the scene file, from 1; 0 for none.
fn keep_object(pixel: vec2u, ray: Ray, seen: Seen) {
    pixel_layer_object[place_in_tile(pixel)] = seen.object;
}

// Where the ray ended; 0 if that is no place.
fn keep_position(pixel: vec2u, ray: Ray, seen: Seen) {
    pixel_layer_position[place_in_tile(pixel)] = vec3f(select(Real3(0.0), seen.end.x, finite(seen.end.x)));
}

// How light has shifted: its frequency here over what it was where it came from; 0 where nothing was seen.
fn keep_shift(pixel: vec2u, ray: Ray, seen: Seen) {
    pixel_layer_shift[place_in_tile(pixel)] = f32(seen_shift);
}

// How the ray ended: its status code.
fn keep_status(pixel: vec2u, ray: Ray, seen: Seen) {
    pixel_layer_status[place_in_tile(pixel)] = select(ray.status, ESCAPED, ray.status == MISSED);
}

// Integration steps along the ray.
fn keep_steps(pixel: vec2u, ray: Ray, seen: Seen) {
    pixel_layer_steps[place_in_tile(pixel)] = ray.steps;
}

// Where the ray was going at its end, as long as its way there (τ |v|): the direction, and what errors of place are held against.
// Where there is no place to be wrong about τ may not be kept, and the length says nothing.
fn keep_way(pixel: vec2u, ray: Ray, seen: Seen) {
    let way = select(seen.end.v, seen.end.tau * seen.end.v, seen.end.tau > 0.0);
    pixel_layer_way[place_in_tile(pixel)] = select(vec3f(0.0), vec3f(way), finite(way));
}
