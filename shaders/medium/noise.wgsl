// A medium of noise (T §2.4): n = n₀ + amplitude · Σ 2⁻ʲ noise(2ʲ · frequency · (x − c)).

struct Medium {
    center: Real3,
    n0: Real,
    amplitude: Real,
    frequency: Real,
    octaves: u32,
    seed: u32,
}

var<uniform> media: array<Medium, MEDIA_COUNT>;

// Returns ∇n and n.
fn noise_index(x: Real3) -> Real4 {
    let medium = media[place];
    let noise = fractal_noise(medium.frequency * (x - medium.center), medium.octaves, medium.seed);
    return Real4(medium.amplitude * medium.frequency * noise.xyz, medium.n0 + medium.amplitude * noise.w);
}

fn medium_index(x: Real3) -> Real {
    return noise_index(x).w;
}

// Returns ∇(n²/2).
fn medium_pull(x: Real3) -> Real3 {
    let n = noise_index(x);
    return n.w * n.xyz;
}

// Returns the characteristic length of the index: a cell of the finest octave.
fn medium_length(x: Real3) -> Real {
    return 1.0 / (Real(1u << (media[place].octaves - 1u)) * media[place].frequency);
}
