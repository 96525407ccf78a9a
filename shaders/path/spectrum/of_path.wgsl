// Of a picture's paths: nothing is stored, for the same point is drawn each time.

// This use of random points.
const WAVELENGTH: u32 = 0x57415645u;

fn draw_wavelength(pixel: vec2u) {
    drawn_wavelength = mix(SHORTEST, LONGEST, seeded_point(hashed(pixel_seed(pixel) ^ WAVELENGTH)).x);
}
