// A lobe's direction is drawn anew for every sample: the samples of one pixel are well spread over it.

fn lobe_point(pixel: vec2u, index: u32) -> vec2f {
    let whole = frame.origin + pixel;
    let seed = hashed(whole.x ^ hashed(whole.y ^ hashed(index)));
    let order = owen_scrambled(frame.sample, seed);
    let x = owen_scrambled(reverseBits(order), hashed(seed ^ 0x9e3779b9u));
    let y = owen_scrambled(sobol_second(order), hashed(seed ^ 0x51633e2du));
    return vec2f(f32(x >> 8u), f32(y >> 8u)) / 16777216.0;
}
