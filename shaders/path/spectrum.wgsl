// Gives a path one wavelength, drawn uniformly from the visible range, and its color. A path has one only after a medium has required its
// wavelength: before that, all wavelengths follow the same path together. Whether it is required does not depend on the wavelength up to
// that point, so that nothing is counted twice.

// The visible range, in nanometers.
const SHORTEST: f32 = 380.0;
const LONGEST: f32 = 730.0;

var<private> drawn_wavelength: f32;

// Returns the wavelength, in micrometers.
fn wavelength() -> Real {
    return 1e-3 * Real(drawn_wavelength);
}

// The number of this use of random points.
const WAVELENGTH: u32 = 0x57415645u;

// Draws a wavelength. Nothing is stored for the paths of an image, because the same point is drawn each time; paths from lights have one
// each.
fn draw_wavelength(pixel: vec2u) {
    if FOLLOWS_PATHS {
        drawn_wavelength = mix(SHORTEST, LONGEST, seeded_point(hashed(pixel_seed(pixel) ^ WAVELENGTH)).x);
    } else {
        let one = hashed(pixel.x ^ hashed(pixel.y ^ hashed(frame.sample)));
        drawn_wavelength = mix(SHORTEST, LONGEST, f32(one >> 8u) / 16777216.0);
    }
}

fn note_dispersed() {
    carried.dispersed = 1u;
}

fn color_dispersed(light: ptr<function, vec3f>) {
    *light *= select(vec3f(1.0), spectral_color(drawn_wavelength), carried.dispersed != 0u);
}

// Returns the color in linear sRGB, approximated without negative components; its mean over all wavelengths is 1.
fn spectral_color(nm: f32) -> vec3f {
    // The CIE 1931 standard observer by sums of lobes (Wyman, Sloan and Shirley 2013).
    let x = 1.056 * spectral_lobe(nm, 599.8, 37.9, 31.0) + 0.362 * spectral_lobe(nm, 442.0, 16.0, 26.7)
        - 0.065 * spectral_lobe(nm, 501.1, 20.4, 26.2);
    let y = 0.821 * spectral_lobe(nm, 568.8, 46.9, 40.5) + 0.286 * spectral_lobe(nm, 530.9, 16.3, 31.1);
    let z = 1.217 * spectral_lobe(nm, 437.0, 11.8, 36.0) + 0.681 * spectral_lobe(nm, 459.0, 26.0, 13.8);
    let linear = vec3f(
        3.2406 * x - 1.5372 * y - 0.4986 * z,
        -0.9689 * x + 1.8758 * y + 0.0415 * z,
        0.0557 * x - 0.2040 * y + 1.0570 * z,
    );
    return max(linear, vec3f(0.0)) / SPECTRAL_MEAN;
}

// The mean over all wavelengths that are drawn: their uniform mixture is white.
const SPECTRAL_MEAN: vec3f = vec3f(0.503379, 0.329663, 0.312275);

fn spectral_lobe(nm: f32, middle: f32, below: f32, above: f32) -> f32 {
    let off = (nm - middle) / select(above, below, nm < middle);
    return exp(-0.5 * off * off);
}
