// Where rays stop when a segment is one step and some objects move: a gap closes as fast as the ray goes beside its object.

fn stops_inside(code: u32) -> bool {
    return ends_on_surface(code) || code == ESCAPED || code == CAPTURED;
}

fn stop_gap(code: u32, hit: Hit, x: Real3) -> Real4 {
    if ends_on_surface(code) {
        let surface = hit_surface(hit.primitive, x);
        // Of what a step's τ changes the surface goes back by its own way.
        let beside = dot(surface.across, met_travel) / dot(met_velocity, met_velocity);
        return Real4(surface.across + beside * met_velocity, surface.gap);
    }
    return open_gap(code, x);
}

fn first_guess(code: u32, hit: Hit, step: LastStep) -> Real {
    return select(open_guess(code, step), own_fraction(step.phase, step.end, hit.t) * step.h, ends_on_surface(code));
}

fn segment_end(ray: Ray, hit: Hit, step: LastStep) -> PathPoint {
    return PathPoint(step.end[0].xyz, step.end[1].xyz, step.end_tau, 1.0);
}
