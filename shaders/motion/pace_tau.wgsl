// Measures steps in τ itself, which may be the path length.

// Returns the size of the step from `ray` to `next`, in the parameter that `retaken_step` takes.
fn own_size(ray: Ray, next: Ray) -> Real {
    return next.taken;
}

// Returns τ in that parameter, along the line from p.
fn own_measure(p: Phase, tau: Real) -> Real {
    if BY_LENGTH {
        return tau * length(p[1].xyz);
    }
    return tau;
}

// Returns the rate of τ in that parameter.
fn own_pace(p: Phase) -> Real {
    if BY_LENGTH {
        return 1.0 / length(p[1].xyz);
    }
    return 1.0;
}

fn own_tau(p: Phase, end: Phase, h: Real) -> Real {
    return h;
}

// Converts a fraction of a step's τ to a fraction of the step's size.
fn own_fraction(p: Phase, end: Phase, t: Real) -> Real {
    return t;
}
