// Velocities are taken as they are, and a ray's time begins with it.

fn law_start(x: Real3, v: Real3) -> Phase {
    if CARRIES_TIME {
        return Phase(Real4(x, 0.0), Real4(v, 0.0));
    }
    return Phase(x, v);
}
