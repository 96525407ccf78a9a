// Reading an ended ray's state from the slot that its status names, of two.

@group(0) @binding(30) var x_0: texture_2d<f32>;
@group(0) @binding(31) var x_1: texture_2d<f32>;
@group(0) @binding(33) var v_0: texture_2d<f32>;
@group(0) @binding(34) var v_1: texture_2d<f32>;
@group(0) @binding(36) var clock_0: texture_2d<f32>;
@group(0) @binding(37) var clock_1: texture_2d<f32>;

fn slot_x(slot: u32, pixel: vec2u) -> vec4f {
    return select(textureLoad(x_0, pixel, 0), textureLoad(x_1, pixel, 0), slot == 1u);
}

fn slot_v(slot: u32, pixel: vec2u) -> vec4f {
    return select(textureLoad(v_0, pixel, 0), textureLoad(v_1, pixel, 0), slot == 1u);
}

fn slot_clock(slot: u32, pixel: vec2u) -> f32 {
    return select(textureLoad(clock_0, pixel, 0).x, textureLoad(clock_1, pixel, 0).x, slot == 1u);
}
