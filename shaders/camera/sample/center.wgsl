// One sample: the pixel's centre.

fn nth_point(pixel: vec2u, n: u32) -> vec2f {
    return vec2f(pixel) + 0.5;
}
