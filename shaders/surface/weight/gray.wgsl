// As surface/weight/colored.wgsl, where nothing on the way has a colour.

@group(0) @binding(142) var weight_all: texture_storage_2d<r32float, read_write>;

var<private> weight: f32;

fn load_weight(pixel: vec2u) {
    weight = textureLoad(weight_all, pixel).x;
}

fn store_weight(pixel: vec2u) {
    textureStore(weight_all, pixel, vec4f(weight));
}

fn start_weight(x: Real3) {
    let n = medium_index(x);
    weight = f32(n * n);
}

fn scale_weight(factor: vec3f) -> f32 {
    weight *= factor.x;
    return weight;
}

fn end_weight(x: Real3) -> vec3f {
    let n = medium_index(x);
    return vec3f(weight / f32(n * n));
}
