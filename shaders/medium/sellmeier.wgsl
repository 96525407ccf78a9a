// Dispersion by the Sellmeier formula: n² = 1 + Σ B λ²/(λ² − C), constant in space.

struct Medium {
    @align(32) b: Real4,
    // The coefficients C, in square micrometers.
    c: Real4,
}

var<uniform> media: array<Medium, MEDIA_COUNT>;

fn medium_index(x: Real3) -> Real {
    if COLORS_DISPERSED {
        note_dispersed();
    }
    let medium = media[place];
    let square = wavelength() * wavelength();
    return sqrt(1.0 + dot(medium.b, square / (Real4(square) - medium.c)));
}

// Returns ∇(n²/2).
fn medium_pull(x: Real3) -> Real3 {
    return Real3(0.0);
}

// The index is constant, so that the length is the radius of the bounding sphere.
fn medium_length(x: Real3) -> Real {
    return bound.radius;
}
