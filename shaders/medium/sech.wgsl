// n = n₀ sech(g y), y being the distance from a plane: sinh(g y) is sinusoidal along a path, with one period for all rays.

struct Medium {
    origin: Real3,
    up: Real3,
    n0: Real,
    g: Real,
}

var<uniform> media: array<Medium, MEDIA_COUNT>;

// Returns sech and tanh of g y, by e^(−|g y|), which does not overflow.
fn sech_tanh(x: Real3) -> Real2 {
    let u = media[place].g * dot(x - media[place].origin, media[place].up);
    let e = real_exp(-abs(u));
    let below = 1.0 + e * e;
    let tanh = (1.0 - e * e) / below;
    return Real2(2.0 * e / below, select(-tanh, tanh, u > 0.0));
}

fn medium_index(x: Real3) -> Real {
    return media[place].n0 * sech_tanh(x).x;
}

// Returns ∇(n²/2).
fn medium_pull(x: Real3) -> Real3 {
    let s = sech_tanh(x);
    let n = media[place].n0 * s.x;
    return (-media[place].g * n * n * s.y) * media[place].up;
}

// Returns the characteristic length of the index, in scene units.
fn medium_length(x: Real3) -> Real {
    return 1.0 / media[place].g;
}
