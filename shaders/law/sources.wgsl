// Force centres whose accelerations add (G95 §2.1, W04 §5.2): dv = −Σ strength · d(r) n̂. v is taken as it is: Newtonian
// motion does not keep the speed.

fn law_rate(p: Phase) -> Phase {
    return Phase(p[1], source_acceleration(p[0]));
}

fn law_start(x: vec3f, v: vec3f) -> Phase {
    return Phase(x, v);
}

fn law_settled(p: Phase) -> Phase {
    return p;
}

// The tau to the nearest centre at this speed.
fn law_scale(p: Phase) -> f32 {
    return source_distance(p[0]) / length(p[1]);
}
