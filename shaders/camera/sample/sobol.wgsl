// Takes the samples of a pixel from one Sobol sequence, every prefix of which is well distributed.

fn nth_point(pixel: vec2u, n: u32) -> vec2f {
    let seed = hashed(pattern_seed(pixel));
    let x = owen_scrambled(reverseBits(n), seed);
    let y = owen_scrambled(sobol_second(n), hashed(seed ^ 0x51633e2du));
    return vec2f(pixel) + vec2f(f32(x >> 8u), f32(y >> 8u)) / 16777216.0;
}
