// Orbits among objects: every step is a separate arc, short enough in r too for a cubic to follow.

// Returns the size of the step from `ray` to `next`, in the parameter that `retaken_step` takes.
fn own_size(ray: Ray, next: Ray) -> Real {
    return next.memory.h;
}

fn accepted_step(ray: Ray) -> Ray {
    let start = orbit_of(ray.phase[0], ray.phase[1]);
    let s = orbit_arc_stride(start, control.eta, start.u);
    let end = orbit_step(start, s);
    let passed = orbit_time(start, end, s);
    var next = after_step(ray, orbit_point(end), passed);
    next.memory.h = opaque(s);
    return next;
}

// Limits steps for an arc. Steps in the plane of an orbit need no further limit. On a separated orbit the axes turn with ψ by at most η,
// and on the way in Δ falls to half its value at most, because τ and ψ diverge towards the horizon.
fn orbit_arc_stride(o: Orbit, eta: Real, size: Real) -> Real {
    if IS_PLANE {
        return orbit_stride(o, eta, size);
    }
    let closing = o.w * (law.mass - (dot(law.spin, law.spin) + law.charge_squared) * o.u);
    let delta = orbit_delta(o.u);
    let half = select(Real(1e30), 0.25 * delta / closing, min(delta, closing) > 0.0);
    let dragged = length(law.spin) * abs(o.gap - o.energy);
    return min(orbit_stride(o, eta, size), min(half, eta / max(dragged, 1e-30)));
}
