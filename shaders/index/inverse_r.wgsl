// n = k/r (thesis Eq. 17).

struct Medium {
    center: Real3,
    k: Real,
    // Nearer to the centre rays are captured.
    capture: Real,
    // 1 where ingoing rays are taken for outgoing ones.
    continued: u32,
}

@group(0) @binding(50) var<uniform> media: array<Medium, MEDIA_COUNT>;

fn medium_index(x: Real3) -> Real {
    return media[place].k / length(x - media[place].center);
}

// ∇(n²/2) = −k² d/r⁴.
fn medium_pull(x: Real3) -> Real3 {
    let d = x - media[place].center;
    let rr = dot(d, d);
    let q = media[place].k / rr;
    return -(q * q) * d;
}

// The length over which the index changes.
fn medium_length(x: Real3) -> Real {
    return length(x - media[place].center);
}
