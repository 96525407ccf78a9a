// Where the ray was going at its end, as long as its way there (τ |v|): the direction, and what errors of place are held against.
// Where there is no place to be wrong about τ may not be kept, and the length says nothing.

@group(0) @binding(162) var layer_way: texture_storage_2d<rgba32float, write>;

fn keep_way(pixel: vec2u, ray: Ray, seen: Seen) {
    let way = select(seen.end.v, seen.end.tau * seen.end.v, seen.end.tau > 0.0);
    textureStore(layer_way, pixel, vec4f(select(vec3f(0.0), vec3f(way), finite(way)), 0.0));
}
