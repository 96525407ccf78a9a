// Selects the pixels of the image that are computed: the pixels of the tile, or pixels from a list if only a few rays are needed. With a
// list, positions in the tile are positions in the list.

var<storage, read> chosen: array<vec2u>;

fn sampled_pixel(pixel: vec2u) -> vec2u {
    if !CHOOSES_PIXELS {
        return frame.origin + pixel;
    }
    return chosen[min(place_in_tile(pixel), arrayLength(&chosen) - 1u)];
}
