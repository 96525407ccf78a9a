// Layers of a ray's end, besides its colour: of a pixel's first sample, for positions and ids have no average.

@group(0) @binding(156) var layer_depth: texture_storage_2d<r32float, write>;
@group(0) @binding(157) var layer_normal: texture_storage_2d<rgba32float, write>;
@group(0) @binding(158) var layer_object: texture_storage_2d<r32uint, write>;
@group(0) @binding(159) var layer_position: texture_storage_2d<rgba32float, write>;
@group(0) @binding(169) var layer_shift: texture_storage_2d<r32float, write>;
@group(0) @binding(160) var layer_status: texture_storage_2d<r32uint, write>;
@group(0) @binding(161) var layer_steps: texture_storage_2d<r32uint, write>;
@group(0) @binding(162) var layer_way: texture_storage_2d<rgba32float, write>;

// How far along its path the ray ended, in segments: whole ones and a fraction (W04 §3.3's depth).
fn keep_depth(pixel: vec2u, ray: Ray, seen: Seen) {
    textureStore(layer_depth, pixel, vec4f(f32(ray.index) + f32(seen.end.fraction)));
}

// The surface's normal, towards the viewer; 0 where nothing was hit.
fn keep_normal(pixel: vec2u, ray: Ray, seen: Seen) {
    textureStore(layer_normal, pixel, vec4f(seen.normal, 0.0));
}

// The object that was hit: its place in the scene file, from 1; 0 for none.
fn keep_object(pixel: vec2u, ray: Ray, seen: Seen) {
    textureStore(layer_object, pixel, vec4u(seen.object));
}

// Where the ray ended; 0 if that is no place.
fn keep_position(pixel: vec2u, ray: Ray, seen: Seen) {
    let x = select(Real3(0.0), seen.end.x, finite(seen.end.x));
    textureStore(layer_position, pixel, vec4f(vec3f(x), 1.0));
}

// How light has shifted: its frequency here over what it was where it came from; 0 where nothing was seen.
fn keep_shift(pixel: vec2u, ray: Ray, seen: Seen) {
    textureStore(layer_shift, pixel, vec4f(f32(seen_shift)));
}

// How the ray ended: its status code.
fn keep_status(pixel: vec2u, ray: Ray, seen: Seen) {
    textureStore(layer_status, pixel, vec4u(select(ray.status, ESCAPED, ray.status == MISSED)));
}

// Integration steps along the ray.
fn keep_steps(pixel: vec2u, ray: Ray, seen: Seen) {
    textureStore(layer_steps, pixel, vec4u(ray.steps));
}

// Where the ray was going at its end, as long as its way there (τ |v|): the direction, and what errors of place are held against.
// Where there is no place to be wrong about τ may not be kept, and the length says nothing.
fn keep_way(pixel: vec2u, ray: Ray, seen: Seen) {
    let way = select(seen.end.v, seen.end.tau * seen.end.v, seen.end.tau > 0.0);
    textureStore(layer_way, pixel, vec4f(select(vec3f(0.0), vec3f(way), finite(way)), 0.0));
}
