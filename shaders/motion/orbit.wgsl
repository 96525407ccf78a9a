// Steps in the plane of an orbit, in which it stays. They are measured in s, with ds = dτ/r².

struct Control {
    // Radians about the centre.
    eta: Real,
}

@group(0) @binding(75) var<uniform> control: Control;

fn retaken_step(p: Phase, s: Real) -> Phase {
    return orbit_point(orbit_step(orbit_of(p[0], p[1]), s));
}

// τ in that measure, along the line from p: for a straight line s = τ/(r₀ r₁), as far as an angle is its sine.
fn own_measure(p: Phase, tau: Real) -> Real {
    let x = p[0] - orbit_center();
    return tau * inverseSqrt(dot(x, x) * dot(x + tau * p[1], x + tau * p[1]));
}

// How fast τ goes in it.
fn own_pace(p: Phase) -> Real {
    let x = p[0] - orbit_center();
    return dot(x, x);
}

fn own_tau(p: Phase, end: Phase, h: Real) -> Real {
    return orbit_time(orbit_of(p[0], p[1]), orbit_of(end[0], end[1]), h);
}

// A fraction of a step's τ as a fraction of its size.
fn own_fraction(p: Phase, end: Phase, t: Real) -> Real {
    let at = distance(mix(p[0], end[0], t), orbit_center());
    return t * distance(end[0], orbit_center()) / at;
}

// Steps and nothing else.
fn bare_steps(ray: Ray, most: u32) -> Ray {
    var o = orbit_of(ray.phase[0], ray.phase[1]);
    var passed: Real = 0.0;
    for (var i = 0u; i < most; i++) {
        work += 1u;
        if work >= WORK_LIMIT {
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
