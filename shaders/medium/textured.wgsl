// An index that varies over a surface alone (T §5.2.1): n₀ + amplitude · Σ 2⁻ʲ noise(2ʲ · frequency · (x − c)) where light enters or
// leaves, and straight paths in between.

struct Medium {
    center: Real3,
    n0: Real,
    amplitude: Real,
    frequency: Real,
    octaves: u32,
    seed: u32,
}

var<uniform> media: array<Medium, MEDIA_COUNT>;

fn medium_index(x: Real3) -> Real {
    let medium = media[place];
    let noise = fractal_noise(medium.frequency * (x - medium.center), medium.octaves, medium.seed);
    return medium.n0 + medium.amplitude * noise.w;
}

// Deliberately not ∇(n²/2): nothing bends light inside.
fn medium_pull(x: Real3) -> Real3 {
    return Real3(0.0);
}

// Paths inside are straight, so that the length is the radius of the bounding sphere.
fn medium_length(x: Real3) -> Real {
    return bound.radius;
}
