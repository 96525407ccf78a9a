// Steps in the plane of the orbit, in which it stays.

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
