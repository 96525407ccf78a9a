// An index that the user wrote as a formula of the position relative to a center. The generated code also computes its gradient.

struct Medium {
    center: Real3,
    scale: Real,
}

var<uniform> media: array<Medium, MEDIA_COUNT>;

fn medium_index(x: Real3) -> Real {
    return limited_index(formula(x - media[place].center).w);
}

// Returns ∇(n²/2).
fn medium_pull(x: Real3) -> Real3 {
    return limited_pull(formula(x - media[place].center));
}

// Returns the characteristic length of the index, in scene units.
fn medium_length(x: Real3) -> Real {
    return media[place].scale;
}
