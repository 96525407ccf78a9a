// Light of one wavelength a path, drawn evenly from all that is visible.

// Nanometres.
const SHORTEST: f32 = 380.0;
const LONGEST: f32 = 730.0;

var<private> drawn_wavelength: f32;

// Micrometres.
fn wavelength() -> Real {
    return 1e-3 * Real(drawn_wavelength);
}
