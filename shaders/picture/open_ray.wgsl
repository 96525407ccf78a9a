// A transparent sky behind rays: what would be seen of it is not covered by the picture.

fn see_through(pixel: vec2u, code: u32, x: Real3) {
    if code == ESCAPED || code == MISSED {
        uncover(pixel, end_weight(x));
    }
}
