// An exponential atmosphere: n = 1 + δ e^(−y/H), y being the height above the origin.

struct Medium {
    origin: Real3,
    up: Real3,
    delta: Real,
    height: Real,
}

var<uniform> media: array<Medium, MEDIA_COUNT>;

// Returns n − 1.
fn excess(x: Real3) -> Real {
    let y = dot(x - media[place].origin, media[place].up);
    return media[place].delta * real_exp(-y / media[place].height);
}

fn medium_index(x: Real3) -> Real {
    return max(1.0 + excess(x), 0.0);
}

// Returns ∇(n²/2).
fn medium_pull(x: Real3) -> Real3 {
    let more = excess(x);
    return (-(1.0 + more) * more / media[place].height) * media[place].up;
}

// Returns the characteristic length of the index, in scene units.
fn medium_length(x: Real3) -> Real {
    return media[place].height;
}
