// Takes one sample per pixel, at its center.

fn nth_point(pixel: vec2u, n: u32) -> vec2f {
    return vec2f(vec2i(pixel)) + 0.5;
}
