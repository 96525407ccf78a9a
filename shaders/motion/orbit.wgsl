// Steps of an orbit around the only center of its law, by an equation of 1/r.

struct Control {
    // The angle around the center that a step may turn through, in radians.
    eta: Real,
}

var<uniform> control: Control;

fn retaken_step(p: Phase, s: Real) -> Phase {
    return orbit_point(orbit_step(orbit_of(p[0], p[1]), s));
}

fn own_tau(p: Phase, end: Phase, h: Real) -> Real {
    return orbit_time(orbit_of(p[0], p[1]), orbit_of(end[0], end[1]), h);
}

// Takes steps and does nothing else.
fn bare_steps(ray: Ray, most: u32) -> Ray {
    var o = orbit_of(ray.phase[0], ray.phase[1]);
    var passed: Real = 0.0;
    for (var i = 0u; i < most; i++) {
        if is_spent() {
            break;
        }
        let s = orbit_stride(o, control.eta, o.u);
        let end = orbit_step(o, s);
        passed += orbit_time(o, end, s);
        o = end;
    }
    var next = ray;
    next.phase = orbit_point(o);
    next.tau += passed;
    next.steps += most;
    return next;
}
