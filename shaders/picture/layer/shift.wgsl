// How light has shifted: its frequency here over what it was where it came from; 0 where nothing was seen.

@group(0) @binding(169) var layer_shift: texture_storage_2d<r32float, write>;

fn keep_shift(pixel: vec2u, ray: Ray, seen: Seen) {
    textureStore(layer_shift, pixel, vec4f(f32(seen_shift)));
}
