// How far along its path the ray ended, in segments: whole ones and a fraction (W04 §3.3's depth).

@group(0) @binding(156) var layer_depth: texture_storage_2d<r32float, write>;

fn keep_depth(pixel: vec2u, ray: Ray, seen: Seen) {
    textureStore(layer_depth, pixel, vec4f(f32(ray.index) + f32(seen.end.fraction)));
}
