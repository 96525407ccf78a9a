// Straight lines, followed by a general solver: what the other laws are compared with.

fn law_rate(p: Phase) -> Phase {
    return Phase(p[1], vec3f(0.0));
}

fn law_start(x: vec3f, v: vec3f) -> Phase {
    return Phase(x, v);
}

fn law_settled(p: Phase) -> Phase {
    return p;
}

// Nothing changes: the way through the whole bounding sphere.
fn law_scale(p: Phase) -> f32 {
    return bound.radius / length(p[1]);
}
