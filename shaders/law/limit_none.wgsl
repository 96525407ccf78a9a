// Paths have no length of their own.

fn limited_step(h: Real, ray: Ray) -> Real {
    return h;
}

fn length_reached(tau: Real) -> bool {
    return false;
}
