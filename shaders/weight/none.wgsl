// Every ray counts for itself alone.

fn start_weight(pixel: vec2u, x: Real3) {
}

fn scale_weight(pixel: vec2u, factor: vec3f) -> f32 {
    return 1.0;
}

fn end_weight(pixel: vec2u, x: Real3) -> vec3f {
    return vec3f(1.0);
}
