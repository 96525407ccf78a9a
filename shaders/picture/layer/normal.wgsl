// The surface's normal, towards the viewer; 0 where nothing was hit.

@group(0) @binding(157) var layer_normal: texture_storage_2d<rgba32float, write>;

fn keep_normal(pixel: vec2u, ray: Ray, seen: Seen) {
    textureStore(layer_normal, pixel, vec4f(seen.normal, 0.0));
}
