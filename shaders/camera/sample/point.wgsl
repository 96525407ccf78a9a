// Computes sample points in their order. With adaptive sampling the first ray of a pixel passes through its top left corner, which it
// shares with its neighbors. If footprints are measured, the rays through the corners are separate and are not samples.

// The sample number that represents the corners.
const CORNERS: u32 = 0x80000000u;
// The sample number that represents the centers of pixels, which form the grid on which stars are found. If an image has one sample per
// pixel, that sample is the grid.
const CENTERS: u32 = 0x80000001u;

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
    if KEEPS_FOOTPRINTS {
        if frame.sample == CORNERS {
            return vec2f(pixel);
        }
    }
    if HAS_STARS {
        if frame.sample == CENTERS {
            // Pixels to the left of the image and above it have negative positions.
            return vec2f(vec2i(pixel)) + 0.5;
        }
    }
    return nth_point(pixel, frame.sample);
}
