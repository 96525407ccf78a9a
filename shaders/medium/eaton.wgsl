// The Eaton lens: n² = 2R/r − 1, 1 at R and infinite at the center. Its pull is Newtonian, and paths are ellipses with a focus there: a ray
// leaves antiparallel to the direction in which it entered.

struct Medium {
    center: Real3,
    radius: Real,
}

var<uniform> media: array<Medium, MEDIA_COUNT>;

// Returns n, 0 from 2R on, which no ray reaches.
fn medium_index(x: Real3) -> Real {
    return sqrt(max(2.0 * media[place].radius / distance(x, media[place].center) - 1.0, 0.0));
}

// Returns ∇(n²/2).
fn medium_pull(x: Real3) -> Real3 {
    let d = x - media[place].center;
    let r2 = dot(d, d);
    return (-media[place].radius / (r2 * sqrt(r2))) * d;
}

// Returns the characteristic length of the index, in scene units.
fn medium_length(x: Real3) -> Real {
    return distance(x, media[place].center);
}
