// Absorption in media (T 2.3, 4.4), as matter at rest that fills the region of a medium. The transmittance of a path is exp(−∫ σ ds), where
// s is length in the scene and σ = −ln c, c being the color that remains after a unit length. Media may emit:
// d(L/n²)/ds = ε/n² − σ L/n².

struct Absorption {
    // The color after a unit length where a texture is 0, or the coefficient of a uniform absorber.
    color: vec3f,
    kind: u32,
    // The color after a unit length where a texture is 1.
    high: vec3f,
    // The largest error of an optical depth, relative to the depth where it is above 1.
    tolerance: f32,
    // The origin of textures and formulas.
    center: Real3,
    // The largest length of a piece.
    piece: f32,
    // The radiance that the medium emits, per unit length.
    emission: vec3f,
    // Lattice cells per unit length.
    frequency: f32,
    axis: vec3f,
    octaves: u32,
    seed: u32,
    // The number of turns of a wrapped texture, or the amplitude of the noise in marble.
    times: f32,
    // The index of the formulas or of the image.
    which: u32,
}

var<storage, read> absorptions: array<Absorption>;

// The absorption of the current step's region.
var<private> absorption: Absorption;

// Finds the absorption of a step. Each region has its own, and the space outside all regions has the last one.
fn enter_medium() {
    var place = 0u;
    if HAS_REGIONS {
        place = min(medium_object(), REGION_COUNT);
    }
    absorption = absorptions[place];
}

// Adds the medium's matter at a point of a path. Light of given frequencies has the mean of the colors.
fn add_medium(spot: Spot, matter: ptr<function, Matter>) {
    let p = placed_by_origin(spot, absorption.center);
    var dim = absorption_density(absorption, p);
    var bright = absorption.emission;
    if IS_SPECTRAL {
        let mean = (dim.x + dim.y + dim.z) / 3.0;
        dim = vec3f(select(mean, -1.0, any(dim < vec3f(0.0))));
        bright = vec3f((bright.x + bright.y + bright.z) / 3.0);
    }
    if BOUNDS_MEDIA {
        see_medium(p);
        for (var k = 0u; k < 3u; k++) {
            see_matter(MEDIUM_SLOT, k, Real2(0.0, Real(dim[k])));
        }
    }
    for (var k = 0u; k < CHANNELS; k++) {
        let own = select(k, 0u, IS_SPECTRAL);
        add_matter(matter, k, spot.length * Real(bright[own]) / spot.index, spot.length * Real(dim[own]));
    }
}

// Returns the absorption coefficient for the color that remains after a unit length; no infinity where the color is 0.
fn density_of(color: vec3f) -> vec3f {
    return -log(max(color, vec3f(1e-30)));
}
