// Where the ray ended.

@group(0) @binding(159) var layer_position: texture_storage_2d<rgba32float, write>;

fn keep_position(pixel: vec2u, ray: Ray, seen: Seen) {
    textureStore(layer_position, pixel, vec4f(vec3f(seen.end.x), 1.0));
}
