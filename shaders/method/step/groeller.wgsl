// Gröller's iteration as printed (G95 §3.1, Table 1): a straight step of length h, and a new velocity that does not depend on h.

const STEP_ORDER: f32 = 1.0;

fn step_ray(p: Phase, h: Real) -> Phase {
    return Phase(p[0] + h * normalize(p[1]), next_velocity(p));
}
