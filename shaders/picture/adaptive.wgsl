// Adaptive sampling: stores the statistics of a pixel's samples, which decide how many it takes.

struct Moments {
    // The sum of the samples while the pixel is open, and their mean once it is done.
    color: vec3f,
    alpha: f32,
    // The sums of the squared distances from the mean (Welford 1962).
    squares: vec3f,
    // The number of rays that the pixel has taken, with flags in the upper bits.
    state: u32,
}

// The flag of a pixel that takes more samples.
const OPEN: u32 = 0x80000000u;
// The flag of a pixel that took all allowed samples without meeting the tolerance.
const CAPPED: u32 = 0x40000000u;
// The mask of the number of rays.
const RAYS: u32 = 0x0000ffffu;

var<storage, read_write> moments: array<Moments>;

// Converts linear light to displayed values, from 0 to 1: exposure, tone map and the sRGB curve (IEC 61966-2-1), as in the PNG.
fn displayed(c: vec3f) -> vec3f {
    let x = clamp(tonemapped(max(c, vec3f(0.0)) * refinement.gain), vec3f(0.0), vec3f(1.0));
    let bent = 1.055 * pow(max(x, vec3f(0.0031308)), vec3f(1.0 / 2.4)) - 0.055;
    return select(bent, 12.92 * x, x <= vec3f(0.0031308));
}

// Applies Narkowicz's fit of the ACES film curve (2015), as in the PNG; without a tone map colors are clamped to 1.
fn tonemapped(x: vec3f) -> vec3f {
    if !IS_FILMIC {
        return x;
    }
    return x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14);
}

// Sums run over the branches of one sample: pass/refine.wgsl adds up the samples, and needs each by itself.
fn sum_begins() -> bool {
    return frame.branch == 0u;
}

// Every pixel has the ray through its corner; later samples are for pixels whose mean is not accurate enough yet.
fn sample_wanted(pixel: vec2u) -> bool {
    if HAS_GRID {
        if is_grid(pixel) {
            return true;
        }
    }
    return sample_of(pixel) == 0u || (moments[place_in_tile(pixel)].state & OPEN) != 0u;
}

// The end of the ray through each pixel's top left corner, and its object: this distinguishes an edge from a gradient.
var<storage, read_write> pixel_corner_end: array<u32>;

fn keep_corner(pixel: vec2u, ray: Ray, seen: Seen) {
    if sample_of(pixel) + frame.branch == 0u {
        let code = select(ray.status, ESCAPED, ray.status == MISSED);
        pixel_corner_end[place_in_tile(pixel)] = code | (seen.object << 4u);
    }
}

fn load_corner(pixel: vec2u) -> u32 {
    return pixel_corner_end[place_in_tile(pixel)];
}
