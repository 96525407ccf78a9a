// Takes the samples of a pixel from one Sobol sequence, every prefix of which is well distributed. The seed is the pixel's position in the
// whole image, so that tiles and schedules do not show.

fn nth_point(pixel: vec2u, n: u32) -> vec2f {
    let seed = hashed((pixel.x * 0x9e3779b1u) ^ (pixel.y * 0x85ebca77u));
    let x = owen_scrambled(reverseBits(n), seed);
    let y = owen_scrambled(sobol_second(n), hashed(seed ^ 0x51633e2du));
    return vec2f(pixel) + vec2f(f32(x >> 8u), f32(y >> 8u)) / 16777216.0;
}
