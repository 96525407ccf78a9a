// Eaton's lens: n² = 2R/r − 1, 1 at R and infinite at the centre. Its pull is Newton's, and paths are ellipses with a focus there:
// a ray comes back out antiparallel to how it went in.

struct Medium {
    center: Real3,
    radius: Real,
}

var<uniform> media: array<Medium, MEDIA_COUNT>;

// 0 from 2R on, where no ray comes.
fn medium_index(x: Real3) -> Real {
    return sqrt(max(2.0 * media[place].radius / distance(x, media[place].center) - 1.0, 0.0));
}

// ∇(n²/2).
fn medium_pull(x: Real3) -> Real3 {
    let d = x - media[place].center;
    let r2 = dot(d, d);
    return (-media[place].radius / (r2 * sqrt(r2))) * d;
}

// The length over which the index changes.
fn medium_length(x: Real3) -> Real {
    return distance(x, media[place].center);
}
