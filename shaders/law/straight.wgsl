// Straight lines, followed by a general solver: what the other laws are compared with.

// Nothing is held.
fn law_held(p: Phase) -> Real {
    return 0.0;
}

fn law_acceleration(x: Real3, held: Real) -> Real3 {
    return Real3(0.0);
}

fn law_start(x: Real3, v: Real3) -> Phase {
    return Phase(x, v);
}

fn law_projected(p: Phase) -> Phase {
    return p;
}

// Nothing changes: the way through the whole bounding sphere.
fn law_scale(p: Phase) -> Real {
    return bound.radius / length(p[1]);
}
