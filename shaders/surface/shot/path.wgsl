// Paths from a light, as any other ray's.

// Where on a segment a place is nearest, as a fraction of it.
fn nearest_fraction(s: Segment, x: Real3) -> Real {
    let c = s.x1 - s.x0;
    let inverse = 1.0 / max(dot(c, c), 1e-30);
    var t = clamp(dot(x - s.x0, c) * inverse, 0.0, 1.0);
    t = clamp(t + dot(x - segment_point(s, t), c) * inverse, 0.0, 1.0);
    return clamp(t + dot(x - segment_point(s, t), c) * inverse, 0.0, 1.0);
}

fn shot_start(source: Real3, d: Real3) -> Ray {
    let phase = opaque_phase(law_start(source, d));
    return Ray(phase, 0.0, 0.0, first_memory(phase), 0.0, 0u, 0u, 0u, ALIVE);
}
