// Takes velocities as they are; the time of a ray begins with it.

fn law_start(x: Real3, v: Real3) -> Phase {
    if CARRIES_TIME {
        return Phase(Real4(x, 0.0), Real4(v, 0.0));
    }
    return Phase(x, v);
}
