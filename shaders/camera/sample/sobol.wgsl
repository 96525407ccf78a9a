// A pixel's samples as one sequence, every prefix of which is well spread: Sobol's first two dimensions, a (0,2)-sequence, with
// Owen's scrambling by hashes (Burley 2020). It is seeded by the pixel's place in the whole picture, so that tiles and schedules
// do not show.

// PCG's output function.
fn hashed(seed: u32) -> u32 {
    let state = seed * 747796405u + 2891336453u;
    let word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return (word >> 22u) ^ word;
}

// Flips each bit as the bits above it and the seed say: Laine and Karras's hash, with the constants of Vegdahl, on the bits in
// reverse.
fn owen_scrambled(x: u32, seed: u32) -> u32 {
    var v = reverseBits(x);
    v ^= v * 0x3d20adeau;
    v += seed;
    v *= (seed >> 16u) | 1u;
    v ^= v * 0x05526c56u;
    v ^= v * 0x53a22864u;
    return reverseBits(v);
}

// The second dimension; the first is the index with its bits reversed.
fn sobol_second(index: u32) -> u32 {
    var sum = 0u;
    var i = index;
    var direction = 0x80000000u;
    while i != 0u {
        work += 1u;
        sum ^= select(0u, direction, (i & 1u) == 1u);
        direction ^= direction >> 1u;
        i >>= 1u;
    }
    return sum;
}

fn sequence_point(pixel: vec2u, index: u32) -> vec2f {
    let seed = hashed((pixel.x * 0x9e3779b1u) ^ (pixel.y * 0x85ebca77u));
    let x = owen_scrambled(reverseBits(index), seed);
    let y = owen_scrambled(sobol_second(index), hashed(seed ^ 0x51633e2du));
    return vec2f(pixel) + vec2f(f32(x >> 8u), f32(y >> 8u)) / 16777216.0;
}
