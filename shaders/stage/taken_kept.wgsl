// An arc's tangents need the size of its step, from the pass that took it.

@group(0) @binding(26) var taken: texture_storage_2d<r32float, read_write>;

fn store_taken(pixel: vec2u, h: f32) {
    textureStore(taken, pixel, vec4f(h));
}

fn load_taken(pixel: vec2u) -> f32 {
    return textureLoad(taken, pixel).x;
}
