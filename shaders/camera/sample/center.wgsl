// One sample: the pixel's centre.

fn sample_point(pixel: vec2u) -> vec2f {
    return vec2f(pixel) + 0.5;
}
