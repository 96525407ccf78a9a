// A part of a separated orbit, over one or several of its steps: the polynomials of order 5 through its ends, with their first and second
// derivatives. Where matter depends on r and θ alone, no angle and no square root is needed.

struct Stretch {
    start: Orbit,
    end: Orbit,
    // The size, in the parameter s of the orbit.
    s: Real,
    tau: Real,
    // The coefficients of n and u.
    second: Real4,
    third: Real4,
    fourth: Real4,
    fifth: Real4,
}

fn stretch_between(a: Orbit, b: Orbit, s: Real, tau: Real) -> Stretch {
    let y = Real4(a.n, a.u);
    let change = Real4(b.n, b.u) - y;
    let first = s * Real4(a.t, a.w);
    let last = s * Real4(b.t, b.w);
    let second = (0.5 * s * s) * orbit_bend(a);
    let turn = (0.5 * s * s) * orbit_bend(b);
    let third = 10.0 * change - 6.0 * first - 4.0 * last - 3.0 * second + turn;
    let fourth = -15.0 * change + 8.0 * first + 7.0 * last + 3.0 * second - 2.0 * turn;
    let fifth = 6.0 * change - 3.0 * (first + last) - second + turn;
    return Stretch(a, b, s, tau, second, third, fourth, fifth);
}

// Returns the orbit at a fraction of a stretch.
fn stretch_orbit(step: Stretch, f: Real) -> Orbit {
    let first = step.s * Real4(step.start.t, step.start.w);
    let y = Real4(step.start.n, step.start.u) + f * (first + f * (step.second + f * (step.third + f * (step.fourth + f * step.fifth))));
    let rate = first + f * (2.0 * step.second + f * (3.0 * step.third + f * (4.0 * step.fourth + f * (5.0 * step.fifth))));
    let v = rate / step.s;
    var here = step.start;
    here.n = y.xyz;
    here.u = y.w;
    here.t = v.xyz;
    here.w = v.w;
    here.gap = orbit_gap(step.start, here.u, here.w);
    let a = length(law.spin);
    let turns = cubic_at(step.start.angle, step.s * a * (step.start.energy - step.start.gap), step.end.angle, step.s * a * (step.end.energy - step.end.gap), f);
    here.angle = turns.x;
    return here;
}

fn stretch_place(step: Stretch, f: Real) -> Real3 {
    return orbit_point(stretch_orbit(step, f))[0];
}

// Returns the distance from the center, without the angle about the axis.
fn stretch_reach(step: Stretch, f: Real) -> Real {
    let here = stretch_orbit(step, f);
    let r = 1.0 / here.u;
    return sqrt(r * r + dot(law.spin, law.spin) * dot(here.n.xy, here.n.xy));
}

// Returns 1/r and its slope by the fraction of the stretch.
fn stretch_rise(step: Stretch, f: Real) -> Real2 {
    let here = stretch_orbit(step, f);
    return Real2(here.u, step.s * here.w);
}

// Returns about the length of a stretch, and its distance from the center, to which rounding is relative.
fn stretch_extent(step: Stretch, until: Real) -> Real2 {
    let r = 1.0 / step.start.u;
    let turn = r * step.start.w;
    return Real2(step.s * r * sqrt(dot(step.start.t, step.start.t) + turn * turn), r);
}

// Returns the rest of a path to the horizon, as a fraction of the stretch at the rate here; it counts if it is positive.
fn stretch_left(step: Stretch, f: Real) -> Real {
    let here = stretch_orbit(step, f);
    return here.u * (1.0 - transfer.horizon * here.u) / (step.s * here.w);
}

// Returns the position and the light at a fraction of a stretch.
fn stretch_spot(step: Stretch, f: Real) -> Spot {
    let here = stretch_orbit(step, f);
    let point = orbit_point(here);
    let r = 1.0 / here.u;
    var spot: Spot;
    spot.x = point[0];
    spot.r = r;
    spot.cosine = here.n.z;
    spot.sine = length(here.n.xy);
    spot.higher = 1.0;
    spot.index = 1.0;
    if VOLUMES_CHANGE {
        spot.tau = step.tau + orbit_time(step.start, here, f * step.s);
        spot.time = Real(transfer.time) - spot.tau;
    }
    if MEDIA_ABSORB || !SHIFTS_VOLUMES {
        spot.length = step.s * orbit_pace(here, here.u, here.n.z, here.gap) * length(point[1]);
    }
    if !SHIFTS_VOLUMES {
        spot.pace = spot.length;
        return spot;
    }
    spot.energy = ray_kept.x;
    spot.turning = ray_kept.y;
    let a2 = dot(law.spin, law.spin);
    spot.pace = step.s * (r * r + a2 * here.n.z * here.n.z) * here.energy / ray_kept.x;
    let momentum = law_momentum(point[0], point[1]);
    spot.momentum = (ray_kept.x / momentum.w) * momentum.xyz;
    return spot;
}

// Returns a stretch of no length that begins at a point of an orbit.
fn stretch_from(o: Orbit, tau: Real) -> Stretch {
    return Stretch(o, o, 1.0, tau, Real4(0.0), Real4(0.0), Real4(0.0), Real4(0.0));
}
