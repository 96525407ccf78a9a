// Continues the law beyond the bounding sphere, where there is nothing else: rays follow their orbits in one step, from a camera outside
// (or, given to `trace`, from infinity) to the sphere, and from the sphere to infinity. So a small sphere gives the directions at infinity.

// Estimates along a straight line the s from here to where u is `aim`, outbound or inbound.
fn orbit_estimate(o: Orbit, aim: Real, outbound: bool) -> Real {
    let from_nearest = arc_tangent(-o.w, o.h * o.u);
    let side = sqrt(max(o.w * o.w + o.h * o.h * (o.u - aim) * (o.u + aim), 0.0));
    let to_nearest = arc_tangent(select(-side, side, outbound), o.h * aim);
    let angle = to_nearest - from_nearest;
    let radial = (aim - o.u) / select(o.w, 1e-30, o.w == 0.0);
    return select(angle / max(o.h, 1e-30), radial, abs(angle) < 1e-5);
}

fn orbit_onto(start: Orbit, aim: Real, outbound: bool) -> Orbit {
    var o = start;
    // The error of the estimate is the deflection along the path; the remaining error is of the next order.
    for (var round = 0u; round < 4u; round++) {
        let s = orbit_estimate(o, aim, outbound);
        let steps = select(1u, ASYMPTOTE_STEPS, round == 0u);
        for (var i = 0u; i < steps; i++) {
            o = orbit_step(o, s / Real(steps));
        }
    }
    return o;
}

// Returns the start of the ray of an orbit where it comes in to u = aim.
fn arriving(o: Orbit, aim: Real, status: u32) -> CameraRay {
    let p = orbit_point(orbit_onto(o, aim, false));
    return CameraRay(p[0], p[1], status);
}

// Returns the end of a path and its velocity there, or its velocity at infinity if it escaped.
fn departed(code: u32, x: Real3, v: Real3) -> mat2x3<Real> {
    if !IS_ASYMPTOTIC {
        return mat2x3<Real>(x, v);
    }
    if code != ESCAPED && code != MISSED {
        return mat2x3<Real>(x, v);
    }
    let o = orbit_onto(orbit_of(x, v), 0.0, true);
    return mat2x3<Real>(x, orbit_asymptote(o));
}
