// The first two Sobol dimensions, a (0,2)-sequence, with Owen scrambling by hashes (Burley 2020).

// Flips each bit depending on the bits above it and the seed: the Laine–Karras hash, with the constants of Vegdahl, on the reversed bits.
fn owen_scrambled(x: u32, seed: u32) -> u32 {
    var v = reverseBits(x);
    v ^= v * 0x3d20adeau;
    v += seed;
    v *= (seed >> 16u) | 1u;
    v ^= v * 0x05526c56u;
    v ^= v * 0x53a22864u;
    return reverseBits(v);
}

// Returns the second dimension; the first is the index with its bits reversed. The matrix is Pascal's triangle modulo 2, a product of five
// matrices with one shift each.
fn sobol_second(index: u32) -> u32 {
    var v = reverseBits(index);
    v ^= v << 16u;
    v ^= (v & 0x00ff00ffu) << 8u;
    v ^= (v & 0x0f0f0f0fu) << 4u;
    v ^= (v & 0x33333333u) << 2u;
    return v ^ ((v & 0x55555555u) << 1u);
}

// Returns a point of the unit square for the sample. The samples of one seed are the Sobol points, shuffled and scrambled (padding).
fn seeded_point(seed: u32) -> vec2f {
    let index = owen_scrambled(frame.sample, seed);
    let x = owen_scrambled(reverseBits(index), hashed(seed ^ 0x9e3779b9u));
    let y = owen_scrambled(sobol_second(index), hashed(seed ^ 0x51633e2du));
    return vec2f(f32(x >> 8u), f32(y >> 8u)) / 16777216.0;
}
