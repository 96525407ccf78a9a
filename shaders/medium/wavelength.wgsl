// Gives all light one wavelength.

struct Spectrum {
    // The wavelength, in micrometers.
    wavelength: Real,
}

var<uniform> spectrum: Spectrum;

fn wavelength() -> Real {
    return spectrum.wavelength;
}
