// Luneburg's lens, generalised: n = √(C − r²/R²) (thesis Eq. 16). Its pull is that of a spring.

struct Medium {
    center: Real3,
    radius: Real,
    c: Real,
}

@group(0) @binding(50) var<uniform> media: array<Medium, MEDIA_COUNT>;

fn medium_index(x: Real3) -> Real {
    let q = (x - media[place].center) / media[place].radius;
    return sqrt(max(media[place].c - dot(q, q), 0.0));
}

// ∇(n²/2).
fn medium_pull(x: Real3) -> Real3 {
    return (media[place].center - x) / (media[place].radius * media[place].radius);
}

// The length over which the index changes.
fn medium_length(x: Real3) -> Real {
    return media[place].radius;
}
