// Orbits among objects: every step is an arc of its own, short enough in r too for a cubic to follow.

// The size of the step from ray to next, in the measure that retaken_step takes.
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
