// Computes sample points in their order. With adaptive sampling the first ray of a pixel passes through its top left corner, which it
// shares with its neighbors. The rays of a grid through the centers of pixels are separate and are not samples.

// The sample number that represents the centers.
const CENTERS: u32 = 0x80000000u;

struct SampleShare {
    // The side of the square that each sample represents, where the pixel's side is 1.
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
    if HAS_GRID {
        if frame.sample == CENTERS {
            return center_of(pixel);
        }
    }
    return nth_point(pixel, frame.sample);
}

// Pixels to the left of the image and above it have negative positions.
fn center_of(pixel: vec2u) -> vec2f {
    return vec2f(vec2i(pixel)) + 0.5;
}
