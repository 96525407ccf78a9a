// How the ray ended: its status code.

@group(0) @binding(160) var layer_status: texture_storage_2d<r32uint, write>;

fn keep_status(pixel: vec2u, ray: Ray, seen: Seen) {
    textureStore(layer_status, pixel, vec4u(select(ray.status, ESCAPED, ray.status == MISSED)));
}
