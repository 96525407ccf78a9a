// What is random on a path: for every use of it, at every scattering of every pixel's sample, a point of the unit square. Nothing is
// stored, and the samples of one use are Sobol's points, shuffled and scrambled (Burley 2020, padding).

struct Transport {
    // Scatterings after which a path is cut.
    depth: u32,
    // Scatterings after which roulette begins.
    roulette: u32,
    seed: u32,
}

var<uniform> transport: Transport;

// Uses.
const DIRECTION: u32 = 0u;
// Which lobe, and whether the path goes on.
const CHOICE: u32 = 1u;
const BRANCH: u32 = 16u;

// Of a pixel, wherever it is in its tile.
fn pixel_seed(pixel: vec2u) -> u32 {
    let whole = frame.origin + pixel;
    return hashed(whole.x ^ hashed(whole.y ^ hashed(transport.seed)));
}

fn path_point(pixel: vec2u, own_use: u32) -> vec2f {
    let place = pixel_seed(pixel);
    return seeded_point(hashed(place ^ hashed(carried.scatterings ^ hashed((carried.flight << 16u) ^ own_use))));
}
