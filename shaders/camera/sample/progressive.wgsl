// Samples in the order of the sequence.

fn sample_point(pixel: vec2u) -> vec2f {
    return sequence_point(pixel, frame.sample);
}
