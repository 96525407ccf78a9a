// A medium of constant index.

struct Medium {
    // Elements of a uniform array are a multiple of 16 bytes apart.
    @align(16) n: Real,
}

var<uniform> media: array<Medium, MEDIA_COUNT>;

fn medium_index(x: Real3) -> Real {
    return media[place].n;
}

// Returns ∇(n²/2).
fn medium_pull(x: Real3) -> Real3 {
    return Real3(0.0);
}

// The index is constant, so that the length is the radius of the bounding sphere.
fn medium_length(x: Real3) -> Real {
    return bound.radius;
}
