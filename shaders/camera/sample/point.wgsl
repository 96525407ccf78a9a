// Samples in their order. Rays through the pixel's top left corner, which it shares with its neighbours, are its first where it takes as
// many as it needs, and no samples but apart from them where it is known what pixels see.

// The sample that stands for the corners.
const CORNERS: u32 = 0x80000000u;

struct SampleShare {
    // The side of what each of a pixel's samples stands for, where the pixel's is 1.
    side: f32,
}

var<uniform> sample_share: SampleShare;

fn sample_point(pixel: vec2u) -> vec2f {
    if ADAPTS {
        if frame.sample == 0u {
            return vec2f(pixel);
        }
        return nth_point(pixel, frame.sample - 1u);
    }
    if KEEPS_FOOTPRINTS {
        if frame.sample == CORNERS {
            return vec2f(pixel);
        }
    }
    return nth_point(pixel, frame.sample);
}
