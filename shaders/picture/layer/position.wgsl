// Where the ray ended; 0 if that is no place.

@group(0) @binding(159) var layer_position: texture_storage_2d<rgba32float, write>;

fn keep_position(pixel: vec2u, ray: Ray, seen: Seen) {
    let x = select(Real3(0.0), seen.end.x, finite(seen.end.x));
    textureStore(layer_position, pixel, vec4f(vec3f(x), 1.0));
}
