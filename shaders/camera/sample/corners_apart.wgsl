// Samples in their order, and rays through the pixel's top left corner, which it shares with its neighbours and which is no sample.

// The sample that stands for the corners.
const CORNERS: u32 = 0x80000000u;

struct SampleShare {
    // The side of what each of a pixel's samples stands for, where the pixel's is 1.
    side: f32,
}

@group(0) @binding(56) var<uniform> sample_share: SampleShare;

fn sample_point(pixel: vec2u) -> vec2f {
    if frame.sample == CORNERS {
        return vec2f(pixel);
    }
    return nth_point(pixel, frame.sample);
}
