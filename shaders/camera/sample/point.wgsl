// Computes sample points in their order. With adaptive sampling the first ray of a pixel passes through its top left corner, which it
// shares with its neighbors. The first sample of an image may be a grid of rays through the centers of pixels; other grids are not samples.

// The sample number of a grid that is not a sample.
const CENTERS: u32 = 0x80000000u;

struct SampleShare {
    // The side of the square that each sample represents, where the pixel's side is 1.
    side: f32,
}

var<uniform> sample_share: SampleShare;

// Returns the side of the share of the pixel's sample. The corners of an adaptive image represent whole pixels.
fn share_side(pixel: vec2u) -> f32 {
    if ADAPTS {
        return select(sample_share.side, 1.0, sample_of(pixel) == 0u);
    }
    return sample_share.side;
}

// Returns `true` if the ray of the pixel belongs to the grid.
fn is_grid(pixel: vec2u) -> bool {
    if SAMPLE_IS_GRID {
        return true;
    }
    if FIRST_IS_GRID {
        return is_apart(pixel) | (sample_of(pixel) == 0u);
    }
    return is_apart(pixel);
}

// Returns `true` if it belongs to a grid that is not a sample.
fn is_apart(pixel: vec2u) -> bool {
    return sample_of(pixel) == CENTERS;
}

fn sample_point(pixel: vec2u) -> vec2f {
    if HAS_GRID {
        if is_grid(pixel) {
            return center_of(pixel);
        }
    }
    if ADAPTS {
        if sample_of(pixel) == 0u {
            return vec2f(vec2i(pixel));
        }
        return nth_point(pixel, frame.sample - 1u);
    }
    if CENTERS_FIRST {
        // The pattern continues on the opposite side of the pixel.
        let shifted = vec2f(vec2i(pixel)) + fract(nth_point(pixel, frame.sample) - nth_point(pixel, 0u) + 0.5);
        return select(shifted, center_of(pixel), sample_of(pixel) == 0u);
    }
    return nth_point(pixel, frame.sample);
}

// Pixels to the left of the image and above it have negative positions.
fn center_of(pixel: vec2u) -> vec2f {
    return vec2f(vec2i(pixel)) + 0.5;
}
