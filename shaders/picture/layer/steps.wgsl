// Integration steps along the ray.

@group(0) @binding(161) var layer_steps: texture_storage_2d<r32uint, write>;

fn keep_steps(pixel: vec2u, ray: Ray, seen: Seen) {
    textureStore(layer_steps, pixel, vec4u(ray.steps));
}
