// Which pixels of the picture are looked at: those of the tile, as they lie, or pixels from a list, to look at a few rays: places in the
// tile are then only places in the list.

var<storage, read> chosen: array<vec2u>;

fn sampled_pixel(pixel: vec2u) -> vec2u {
    if !CHOOSES_PIXELS {
        return frame.origin + pixel;
    }
    return chosen[min(place_in_tile(pixel), arrayLength(&chosen) - 1u)];
}
