// The object that was hit: its place in the scene file, from 1; 0 for none.

@group(0) @binding(158) var layer_object: texture_storage_2d<r32uint, write>;

fn keep_object(pixel: vec2u, ray: Ray, seen: Seen) {
    textureStore(layer_object, pixel, vec4u(seen.object));
}
