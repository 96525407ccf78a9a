// First the pixel's top left corner, which it shares with its neighbours, then its samples.

fn sample_point(pixel: vec2u) -> vec2f {
    if frame.sample == 0u {
        return vec2f(pixel);
    }
    return nth_point(pixel, frame.sample - 1u);
}
