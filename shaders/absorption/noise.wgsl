// The fractal sum of noise as a number from 0 to 1 (T Eq. 10): splines overshoot this range and are clamped. It computes values only,
// without the gradients that media need, and has no loop except over octaves.

fn noise_layer(cell: vec3i, seed: u32, across: Real4, up: Real4) -> Real {
    let a = dot(lattice_row(cell - vec3i(0, 1, 0), seed), across);
    let b = dot(lattice_row(cell, seed), across);
    let c = dot(lattice_row(cell + vec3i(0, 1, 0), seed), across);
    let d = dot(lattice_row(cell + vec3i(0, 2, 0), seed), across);
    return dot(Real4(a, b, c, d), up);
}

fn noise_value(p: Real3, seed: u32) -> Real {
    let base = floor(p);
    let t = p - base;
    let cell = vec3i(base);
    let across = spline_weights(t.x);
    let up = spline_weights(t.y);
    let layers = Real4(
        noise_layer(cell - vec3i(0, 0, 1), seed, across, up),
        noise_layer(cell, seed, across, up),
        noise_layer(cell + vec3i(0, 0, 1), seed, across, up),
        noise_layer(cell + vec3i(0, 0, 2), seed, across, up),
    );
    return dot(layers, spline_weights(t.z));
}

fn texture_sum(absorption: Absorption, q: Real3) -> f32 {
    var sum: Real = 0.0;
    var weight: Real = 1.0;
    var place_in_octave = Real(absorption.frequency) * q;
    for (var j = 0u; j < absorption.octaves; j++) {
        sum += weight * noise_value(place_in_octave, absorption.seed);
        place_in_octave *= 2.0;
        weight *= 0.5;
    }
    return f32(sum);
}

// Returns the value in [0, 1] for `sum`, the sum of the texture at a position.
fn texture_share(absorption: Absorption, sum: f32) -> f32 {
    let most = 2.0 - exp2(1.0 - f32(absorption.octaves));
    return clamp(0.5 * sum / most + 0.5, 0.0, 1.0);
}
