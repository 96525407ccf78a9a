// What each pixel's ray hit: the primitive and the fraction of its last segment. Textures of their own, not a part of the
// state: they are written once.

@group(0) @binding(87) var hit_primitive: texture_storage_2d<r32uint, read_write>;
@group(0) @binding(88) var hit_t: texture_storage_2d<r32float, read_write>;

fn store_hit(pixel: vec2u, hit: Hit) {
    textureStore(hit_primitive, pixel, vec4u(hit.primitive));
    textureStore(hit_t, pixel, vec4f(f32(hit.t)));
}

fn load_hit(pixel: vec2u) -> Hit {
    return Hit(Real(textureLoad(hit_t, pixel).x), textureLoad(hit_primitive, pixel).x);
}

fn clear_hit(pixel: vec2u) {
    store_hit(pixel, Hit(0.0, NOTHING));
}
