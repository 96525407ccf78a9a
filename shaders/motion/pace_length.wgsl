// Steps are measured in τ, which is the path's length.

fn own_size(ray: Ray, next: Ray) -> Real {
    return next.taken;
}

// τ along v as length.
fn own_measure(p: Phase, tau: Real) -> Real {
    return tau * length(p[1].xyz);
}

// How fast τ along v goes in it.
fn own_pace(p: Phase) -> Real {
    return 1.0 / length(p[1].xyz);
}

fn own_tau(p: Phase, end: Phase, h: Real) -> Real {
    return h;
}

fn own_fraction(p: Phase, end: Phase, t: Real) -> Real {
    return t;
}
