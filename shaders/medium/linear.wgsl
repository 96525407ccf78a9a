// n² = n₀² + gradient · (x − origin): the air over a hot road. The pull is uniform and paths are parabolas (Evans and Rosenquist 1985).

struct Medium {
    origin: Real3,
    n0: Real,
    gradient: Real3,
}

var<uniform> media: array<Medium, MEDIA_COUNT>;

// Returns n, 0 beyond the plane where n² is 0, which no ray crosses.
fn medium_index(x: Real3) -> Real {
    let medium = media[place];
    return sqrt(max(medium.n0 * medium.n0 + dot(medium.gradient, x - medium.origin), 0.0));
}

// Returns ∇(n²/2).
fn medium_pull(x: Real3) -> Real3 {
    return 0.5 * media[place].gradient;
}

// Returns the characteristic length of the index: a parabola needs no shorter steps anywhere.
fn medium_length(x: Real3) -> Real {
    return min(media[place].n0 * media[place].n0 / length(media[place].gradient), bound.radius);
}
