// Samples in their order.

fn sample_point(pixel: vec2u) -> vec2f {
    return nth_point(pixel, frame.sample);
}
