// A gradient-index rod: n = n₀ √(1 − g²ρ²), ρ being the distance from its axis (Suffern and Getto 1991). Its pull is that of a spring
// towards the axis, so that paths are sinusoidal.

struct Medium {
    center: Real3,
    axis: Real3,
    n0: Real,
    g: Real,
}

var<uniform> media: array<Medium, MEDIA_COUNT>;

// Returns the vector from the axis to x.
fn from_axis(x: Real3) -> Real3 {
    let d = x - media[place].center;
    return d - dot(d, media[place].axis) * media[place].axis;
}

// Returns n, 0 from ρ = 1/g on, which no ray reaches.
fn medium_index(x: Real3) -> Real {
    let q = media[place].g * from_axis(x);
    return media[place].n0 * sqrt(max(1.0 - dot(q, q), 0.0));
}

// Returns ∇(n²/2).
fn medium_pull(x: Real3) -> Real3 {
    let k = media[place].n0 * media[place].g;
    return (-k * k) * from_axis(x);
}

// Returns the characteristic length of the index, in scene units.
fn medium_length(x: Real3) -> Real {
    return 1.0 / media[place].g;
}

// As a spring: x″ = −n₀² g² ρ, ρ being the component of x − c perpendicular to the axis.
fn spring_center() -> Real3 {
    return media[place].center;
}

fn spring_axis() -> Real3 {
    return media[place].axis;
}

fn spring_rate() -> Real {
    return media[place].n0 * media[place].g;
}
