// The generalized Luneburg lens: n = √(C − r²/R²) (T Eq. 16). Its pull is that of a spring.

struct Medium {
    center: Real3,
    radius: Real,
    c: Real,
}

var<uniform> media: array<Medium, MEDIA_COUNT>;

fn medium_index(x: Real3) -> Real {
    let q = (x - media[place].center) / media[place].radius;
    return sqrt(max(media[place].c - dot(q, q), 0.0));
}

// Returns ∇(n²/2).
fn medium_pull(x: Real3) -> Real3 {
    return (media[place].center - x) / (media[place].radius * media[place].radius);
}

// Returns the characteristic length of the index, in scene units.
fn medium_length(x: Real3) -> Real {
    return media[place].radius;
}

// As a spring: x″ = −(x − c)/R², around a point.
fn spring_center() -> Real3 {
    return media[place].center;
}

fn spring_axis() -> Real3 {
    return Real3(0.0);
}

fn spring_rate() -> Real {
    return 1.0 / media[place].radius;
}
