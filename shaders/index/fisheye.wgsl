// Maxwell's fisheye: n = n₀/(1 + r²/a²).

struct Medium {
    center: Real3,
    n0: Real,
    a: Real,
}

@group(0) @binding(50) var<uniform> media: array<Medium, MEDIA_COUNT>;

fn medium_index(x: Real3) -> Real {
    let q = (x - media[place].center) / media[place].a;
    return media[place].n0 / (1.0 + dot(q, q));
}

// ∇(n²/2) = −2 n³ d/(n₀ a²).
fn medium_pull(x: Real3) -> Real3 {
    let q = (x - media[place].center) / media[place].a;
    let n = media[place].n0 / (1.0 + dot(q, q));
    return (-2.0 * n * n * n / (media[place].n0 * media[place].a)) * q;
}

// The length over which the index changes.
fn medium_length(x: Real3) -> Real {
    return max(media[place].a, distance(x, media[place].center));
}
