// Pixels from a list, to look at a few rays of a picture: places in the tile are only places in the list.

@group(0) @binding(53) var<storage, read> chosen: array<vec2u>;

fn sampled_pixel(pixel: vec2u) -> vec2u {
    return chosen[min(pixel.y * frame.size.x + pixel.x, arrayLength(&chosen) - 1u)];
}
