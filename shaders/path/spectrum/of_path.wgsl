// Of a picture's paths: nothing is stored, for the same point is drawn each time.

// This use of random points.
const WAVELENGTH: u32 = 0x57415645u;

fn draw_wavelength(pixel: vec2u) {
    let whole = frame.origin + pixel;
    let place = hashed(whole.x ^ hashed(whole.y ^ hashed(transport.seed)));
    drawn_wavelength = mix(SHORTEST, LONGEST, seeded_point(hashed(place ^ WAVELENGTH)).x);
}
