// First the pixel's top left corner, which it shares with its neighbours, then the sequence.

fn sample_point(pixel: vec2u) -> vec2f {
    if frame.sample == 0u {
        return vec2f(pixel);
    }
    return sequence_point(pixel, frame.sample - 1u);
}
