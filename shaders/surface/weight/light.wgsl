// What is left of a ray's light on its way from a lamp: the parts that surfaces reflect or let through, of all colours together.

@group(0) @binding(142) var weight_all: texture_storage_2d<r32float, read_write>;

var<private> weight: f32;

fn load_weight(pixel: vec2u) {
    weight = textureLoad(weight_all, pixel).x;
}

fn store_weight(pixel: vec2u) {
    textureStore(weight_all, pixel, vec4f(weight));
}

fn start_weight(x: Real3) {
    weight = 1.0;
}

fn scale_weight(factor: vec3f) -> f32 {
    weight *= (factor.x + factor.y + factor.z) / 3.0;
    return weight;
}

fn end_weight(x: Real3) -> vec3f {
    return vec3f(weight);
}

fn light_weight() -> f32 {
    return weight;
}
