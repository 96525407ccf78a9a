// A Gaussian sphere: n = a e^(−b r²/R²) (T §5.2.2). With b = ln a the index at R is 1.

struct Medium {
    center: Real3,
    radius: Real,
    a: Real,
    b: Real,
}

var<uniform> media: array<Medium, MEDIA_COUNT>;

fn medium_index(x: Real3) -> Real {
    let q = (x - media[place].center) / media[place].radius;
    return media[place].a * real_exp(-media[place].b * dot(q, q));
}

// Returns ∇(n²/2).
fn medium_pull(x: Real3) -> Real3 {
    let n = medium_index(x);
    let slope = -2.0 * media[place].b / (media[place].radius * media[place].radius);
    return (slope * n * n) * (x - media[place].center);
}

// Returns the characteristic length of the index: R, or less where it is steep; |n″/n| is at most 2|b|(1 + 2|b| q²)/R².
fn medium_length(x: Real3) -> Real {
    let q = (x - media[place].center) / media[place].radius;
    let b2 = 2.0 * abs(media[place].b);
    return media[place].radius / sqrt(max(b2 * (1.0 + b2 * dot(q, q)), 1.0));
}
