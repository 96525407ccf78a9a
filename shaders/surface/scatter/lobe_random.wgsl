// A lobe's direction is drawn anew for every sample: the samples of one pixel are well spread over it.

fn lobe_point(pixel: vec2u, index: u32) -> vec2f {
    let whole = frame.origin + pixel;
    return seeded_point(hashed(whole.x ^ hashed(whole.y ^ hashed(index))));
}
