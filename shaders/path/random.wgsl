// Random numbers of a path: for every use, at every scattering of every sample of a pixel, a point of the unit square. Nothing is stored,
// and the samples of one use are the Sobol points, shuffled and scrambled (Burley 2020, padding).

// The uses of random points.
const DIRECTION: u32 = 0u;
// The choice of a lobe, and of whether the path continues.
const CHOICE: u32 = 1u;
const BRANCH: u32 = 16u;

// Returns the seed of a pixel, independent of its position in its tile.
fn pixel_seed(pixel: vec2u) -> u32 {
    let whole = frame.origin + pixel;
    return hashed(whole.x ^ hashed(whole.y ^ hashed(transport.seed)));
}

fn path_point(pixel: vec2u, own_use: u32) -> vec2f {
    let place = pixel_seed(pixel);
    return seeded_point(hashed(place ^ hashed(carried.scatterings ^ hashed((carried.flight << 16u) ^ own_use))));
}
