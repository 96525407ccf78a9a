// A segment between two slots of the state, for the schedules that integrate and intersect in different passes.

@group(0) @binding(22) var x_start: texture_2d<f32>;
@group(0) @binding(23) var v_start: texture_2d<f32>;
@group(0) @binding(24) var x_end: texture_2d<f32>;
@group(0) @binding(25) var v_end: texture_2d<f32>;

fn load_segment(pixel: vec2u) -> Segment {
    let x0 = textureLoad(x_start, pixel, 0).xyz;
    let v0 = textureLoad(v_start, pixel, 0).xyz;
    let x1 = textureLoad(x_end, pixel, 0).xyz;
    let v1 = textureLoad(v_end, pixel, 0).xyz;
    return Segment(x0, v0, x1, v1, load_taken(pixel));
}

fn load_tau(pixel: vec2u) -> f32 {
    return textureLoad(x_end, pixel, 0).w;
}
