// Velocities are taken as they are.

fn law_start(x: Real3, v: Real3) -> Phase {
    return Phase(x, v);
}
