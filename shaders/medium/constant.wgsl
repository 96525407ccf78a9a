// The same index everywhere.

struct Medium {
    // Elements of a uniform array are 16 bytes apart, or a multiple of that.
    @align(16) n: Real,
}

var<uniform> media: array<Medium, MEDIA_COUNT>;

fn medium_index(x: Real3) -> Real {
    return media[place].n;
}

// ∇(n²/2).
fn medium_pull(x: Real3) -> Real3 {
    return Real3(0.0);
}

// Nothing changes: the way through the whole bounding sphere.
fn medium_length(x: Real3) -> Real {
    return bound.radius;
}
