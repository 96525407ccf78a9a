// ln k of rays between passes: k times U is light's momentum where the line element changes with t.

@group(0) @binding(174) var stretch_in: texture_2d<f32>;
@group(0) @binding(175) var stretch_0: texture_2d<f32>;
@group(0) @binding(176) var stretch_1: texture_2d<f32>;
@group(0) @binding(177) var stretch_2: texture_2d<f32>;
@group(0) @binding(178) var stretch_out: texture_storage_2d<r32float, write>;

fn load_stretch(pixel: vec2u) -> Real {
    return textureLoad(stretch_in, pixel, 0).x;
}

fn stretch_at_0(pixel: vec2u) -> Real {
    return textureLoad(stretch_0, pixel, 0).x;
}

fn stretch_at_1(pixel: vec2u) -> Real {
    return textureLoad(stretch_1, pixel, 0).x;
}

fn stretch_at_2(pixel: vec2u) -> Real {
    return textureLoad(stretch_2, pixel, 0).x;
}

fn put_stretch(pixel: vec2u, a: Real) {
    textureStore(stretch_out, pixel, vec4f(a));
}
