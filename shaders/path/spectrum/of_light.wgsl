// Of paths from lamps: one each.

fn draw_wavelength(pixel: vec2u) {
    let one = hashed(pixel.x ^ hashed(pixel.y ^ hashed(frame.sample)));
    drawn_wavelength = mix(SHORTEST, LONGEST, f32(one >> 8u) / 16777216.0);
}
