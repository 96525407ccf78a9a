// All light is of one wavelength.

struct Spectrum {
    // Micrometres.
    wavelength: Real,
}

@group(0) @binding(73) var<uniform> spectrum: Spectrum;

fn wavelength() -> Real {
    return spectrum.wavelength;
}
