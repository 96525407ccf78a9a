// Where rays stop in a scene without objects.

fn stops_inside(code: u32) -> bool {
    return code == ESCAPED || code == CAPTURED;
}

fn stop_gap(code: u32, hit: Hit, x: Real3) -> Real4 {
    return open_gap(code, x);
}

fn first_guess(code: u32, hit: Hit, step: LastStep) -> Real {
    return open_guess(code, step);
}

fn segment_end(ray: Ray, hit: Hit, step: LastStep) -> PathPoint {
    return PathPoint(step.end[0].xyz, step.end[1].xyz, step.end_tau, 1.0);
}
