// All light is of one wavelength.

struct Spectrum {
    // Micrometres.
    wavelength: Real,
}

var<uniform> spectrum: Spectrum;

fn wavelength() -> Real {
    return spectrum.wavelength;
}
