// The pixels of the tile, as they lie.

fn sampled_pixel(pixel: vec2u) -> vec2u {
    return frame.origin + pixel;
}
