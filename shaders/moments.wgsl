// What a pixel's samples so far say of it, where adaptive sampling decides how many it takes.

struct Moments {
    // The samples' sum while the pixel is open, and its mean once it is done.
    color: vec3f,
    alpha: f32,
    // Sums of the squared distances from the mean (Welford 1962).
    squares: vec3f,
    // How many rays the pixel has taken, with flags above.
    state: u32,
}

// The pixel takes more samples.
const OPEN: u32 = 0x80000000u;
// The pixel took all samples that it may, and its mean is not good enough.
const CAPPED: u32 = 0x40000000u;
// The rays without the flags.
const RAYS: u32 = 0x0000ffffu;

@group(0) @binding(114) var<storage, read_write> moments: array<Moments>;

fn place_in_tile(pixel: vec2u) -> u32 {
    return pixel.y * frame.size.x + pixel.x;
}
