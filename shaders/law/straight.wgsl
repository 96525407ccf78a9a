// Straight lines, followed by a general solver: the baseline for the other laws.

fn law_acceleration(x: Real3, constant: Real) -> Real3 {
    return Real3(0.0);
}

// The direction is constant, so that the scale is the whole bounding sphere.
fn law_scale(p: Phase) -> Real {
    return bound.radius / length(p[1]);
}
