// n = k/r (T Eq. 17): paths are logarithmic spirals. The index is infinite at the center.

struct Medium {
    center: Real3,
    k: Real,
    // The radius at which rays are captured.
    capture: Real,
    // 1 if ingoing rays are replaced by outgoing ones.
    continued: u32,
}

var<uniform> media: array<Medium, MEDIA_COUNT>;

fn medium_index(x: Real3) -> Real {
    return media[place].k / distance(x, media[place].center);
}

// Returns ∇(n²/2). It avoids r⁴, which leaves the range of f32 long before the pull does.
fn medium_pull(x: Real3) -> Real3 {
    let d = x - media[place].center;
    let q = media[place].k / dot(d, d);
    return -q * (q * d);
}

// Returns the characteristic length of the index, in scene units.
fn medium_length(x: Real3) -> Real {
    return distance(x, media[place].center);
}
