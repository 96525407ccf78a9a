// An index that the user wrote, as a formula of the place relative to a centre. What is generated for it knows its gradient.

struct Medium {
    center: Real3,
    scale: Real,
}

var<uniform> media: array<Medium, MEDIA_COUNT>;

fn medium_index(x: Real3) -> Real {
    return limited_index(formula(x - media[place].center).w);
}

// ∇(n²/2).
fn medium_pull(x: Real3) -> Real3 {
    return limited_pull(formula(x - media[place].center));
}

// The length over which the index changes.
fn medium_length(x: Real3) -> Real {
    return media[place].scale;
}
