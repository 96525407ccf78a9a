// The Maxwell fisheye: n = n₀/(1 + r²/a²). Paths are circles, and all circles through a point meet again in another point.

struct Medium {
    center: Real3,
    n0: Real,
    a: Real,
}

var<uniform> media: array<Medium, MEDIA_COUNT>;

fn medium_index(x: Real3) -> Real {
    let q = (x - media[place].center) / media[place].a;
    return media[place].n0 / (1.0 + dot(q, q));
}

// Returns ∇(n²/2) = −2 n³ (x − c)/(n₀ a²).
fn medium_pull(x: Real3) -> Real3 {
    let q = (x - media[place].center) / media[place].a;
    let share = 1.0 / (1.0 + dot(q, q));
    let n = media[place].n0 * share;
    return (-2.0 * n * n * share / media[place].a) * q;
}

// Returns the characteristic length of the index: a near the center, r far away, where n falls as r⁻².
fn medium_length(x: Real3) -> Real {
    let d = x - media[place].center;
    return sqrt(dot(d, d) + media[place].a * media[place].a);
}
