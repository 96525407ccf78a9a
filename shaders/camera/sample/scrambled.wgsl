// Sobol's first two dimensions, a (0,2)-sequence, with Owen's scrambling by hashes (Burley 2020).

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

// The second dimension; the first is the index with its bits reversed. Its matrix is Pascal's triangle of even and odd, a product of
// five with one shift each.
fn sobol_second(index: u32) -> u32 {
    var v = reverseBits(index);
    v ^= v << 16u;
    v ^= (v & 0x00ff00ffu) << 8u;
    v ^= (v & 0x0f0f0f0fu) << 4u;
    v ^= (v & 0x33333333u) << 2u;
    return v ^ ((v & 0x55555555u) << 1u);
}

// A point of the unit square for the sample: of one seed all samples are Sobol's points, shuffled and scrambled (padding).
fn seeded_point(seed: u32) -> vec2f {
    let index = owen_scrambled(frame.sample, seed);
    let x = owen_scrambled(reverseBits(index), hashed(seed ^ 0x9e3779b9u));
    let y = owen_scrambled(sobol_second(index), hashed(seed ^ 0x51633e2du));
    return vec2f(f32(x >> 8u), f32(y >> 8u)) / 16777216.0;
}
