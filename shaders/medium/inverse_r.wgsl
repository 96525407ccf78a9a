// n = k/r (thesis Eq. 17): paths are logarithmic spirals. At the centre the index is infinite.

struct Medium {
    center: Real3,
    k: Real,
    // Nearer to the centre rays are captured.
    capture: Real,
    // 1 where ingoing rays are taken for outgoing ones.
    continued: u32,
}

var<uniform> media: array<Medium, MEDIA_COUNT>;

fn medium_index(x: Real3) -> Real {
    return media[place].k / distance(x, media[place].center);
}

// ∇(n²/2). Not by r⁴, which leaves the range of f32 long before the pull does.
fn medium_pull(x: Real3) -> Real3 {
    let d = x - media[place].center;
    let q = media[place].k / dot(d, d);
    return -q * (q * d);
}

// The length over which the index changes.
fn medium_length(x: Real3) -> Real {
    return distance(x, media[place].center);
}
