// One number for all colours, between passes.

@group(0) @binding(142) var weight_all: texture_storage_2d<r32float, read_write>;

var<private> weight: f32;

fn load_weight(pixel: vec2u) {
    draw_wavelength(pixel);
    weight = textureLoad(weight_all, pixel).x;
}

fn store_weight(pixel: vec2u) {
    textureStore(weight_all, pixel, vec4f(weight));
}
