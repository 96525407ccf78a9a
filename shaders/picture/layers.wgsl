// Writes the layers of a ray's end, except its color: for the first sample of a pixel, because positions and ids have no average.

var<storage, read_write> pixel_layer_depth: array<f32>;
var<storage, read_write> pixel_layer_segments: array<f32>;
var<storage, read_write> pixel_layer_normal: array<vec3f>;
var<storage, read_write> pixel_layer_object: array<f32>;
var<storage, read_write> pixel_layer_position: array<vec3f>;
var<storage, read_write> pixel_layer_redshift: array<f32>;
var<storage, read_write> pixel_layer_status: array<u32>;
var<storage, read_write> pixel_layer_steps: array<u32>;
var<storage, read_write> pixel_layer_way: array<vec3f>;

// The end of the ray along its path, in segments: whole segments and a fraction (W04 §3.3's depth).
fn keep_segments(pixel: vec2u, ray: Ray, seen: Seen) {
    pixel_layer_segments[place_in_tile(pixel)] = f32(ray.index) + f32(seen.end.fraction);
}

// The length of the path from the camera to the surface, in scene units; NO_DEPTH if the ray hit nothing.
fn keep_depth(pixel: vec2u, ray: Ray, seen: Seen) {
    let way = pixel_path_length[place_in_tile(pixel)] + arc_length(ray.phase, seen.end.x, seen.end.v);
    pixel_layer_depth[place_in_tile(pixel)] = select(NO_DEPTH, way, seen.object > 0u && way < NO_DEPTH);
}

// The surface normal, towards the viewer; 0 if nothing was hit.
fn keep_normal(pixel: vec2u, ray: Ray, seen: Seen) {
    pixel_layer_normal[place_in_tile(pixel)] = seen.normal;
}

// The index of the object that was hit; -1 for none.
fn keep_object(pixel: vec2u, ray: Ray, seen: Seen) {
    pixel_layer_object[place_in_tile(pixel)] = f32(seen.object) - 1.0;
}

// The position where the ray ended; 0 if there is none.
fn keep_position(pixel: vec2u, ray: Ray, seen: Seen) {
    pixel_layer_position[place_in_tile(pixel)] = vec3f(select(Real3(0.0), seen.end.x, finite(seen.end.x)));
}

// The redshift factor: the frequency of light at the camera divided by its frequency at the source; 0 if nothing was seen.
fn keep_redshift(pixel: vec2u, ray: Ray, seen: Seen) {
    pixel_layer_redshift[place_in_tile(pixel)] = f32(seen_shift);
}

// The status code with which the ray ended.
fn keep_status(pixel: vec2u, ray: Ray, seen: Seen) {
    pixel_layer_status[place_in_tile(pixel)] = select(ray.status, ESCAPED, ray.status == MISSED);
}

// The number of integration steps along the ray.
fn keep_steps(pixel: vec2u, ray: Ray, seen: Seen) {
    pixel_layer_steps[place_in_tile(pixel)] = ray.steps;
}

// The direction of the ray at its end, with the length of its path (τ |v|), which position errors are compared with. If no position can be
// wrong, τ may not be stored, and the length has no meaning.
fn keep_way(pixel: vec2u, ray: Ray, seen: Seen) {
    let way = select(seen.end.v, seen.end.tau * seen.end.v, seen.end.tau > 0.0);
    pixel_layer_way[place_in_tile(pixel)] = select(vec3f(0.0), vec3f(way), finite(way));
}
