// A gradient rod: n = n₀ √(1 − g²ρ²), ρ the distance from its axis (Suffern and Getto 1991). Its pull is a spring's towards the
// axis, so that paths are sinusoidal.

struct Medium {
    center: Real3,
    axis: Real3,
    n0: Real,
    g: Real,
}

var<uniform> media: array<Medium, MEDIA_COUNT>;

// From the axis to x.
fn from_axis(x: Real3) -> Real3 {
    let d = x - media[place].center;
    return d - dot(d, media[place].axis) * media[place].axis;
}

// 0 from ρ = 1/g on, where no ray comes.
fn medium_index(x: Real3) -> Real {
    let q = media[place].g * from_axis(x);
    return media[place].n0 * sqrt(max(1.0 - dot(q, q), 0.0));
}

// ∇(n²/2).
fn medium_pull(x: Real3) -> Real3 {
    let k = media[place].n0 * media[place].g;
    return (-k * k) * from_axis(x);
}

// The length over which the index changes.
fn medium_length(x: Real3) -> Real {
    return 1.0 / media[place].g;
}

// As a spring: x″ = −n₀² g² ρ, ρ the part of x − c across the axis.
fn spring_center() -> Real3 {
    return media[place].center;
}

fn spring_axis() -> Real3 {
    return media[place].axis;
}

fn spring_rate() -> Real {
    return media[place].n0 * media[place].g;
}
