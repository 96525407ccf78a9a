// Straight lines, followed by a general solver: what the other laws are compared with.

fn law_acceleration(x: Real3, held: Real) -> Real3 {
    return Real3(0.0);
}

// Nothing changes: the way through the whole bounding sphere.
fn law_scale(p: Phase) -> Real {
    return bound.radius / length(p[1]);
}
