// Finds where rays stop. A segment of one step is retaken up to a surface, the bounding sphere or the capture surface; hits of a chord over
// several steps are on the chord, as in W04.

fn stops_inside(code: u32) -> bool {
    if ENDS_ON_ARCS {
        return ends_on_surface(code) || code == ESCAPED || code == CAPTURED;
    }
    return code == ESCAPED || code == CAPTURED;
}

fn stop_distance(code: u32, hit: Hit, x: Real3) -> Real4 {
    if ENDS_ON_ARCS {
        if ends_on_surface(code) {
            let surface = hit_surface(hit.primitive, x);
            if TRAVELS {
                // The signed distance shrinks at the speed of the ray relative to the object: the motion of the surface takes its part of the step's τ.
                let beside = dot(surface.normal, met_travel) / dot(met_velocity, met_velocity);
                return Real4(surface.normal + beside * met_velocity, surface.signed_distance);
            }
            return Real4(surface.normal, surface.signed_distance);
        }
    }
    return open_gap(code, x);
}

fn first_guess(code: u32, hit: Hit, step: LastStep) -> Real {
    if ENDS_ON_ARCS {
        return select(open_guess(code, step), own_fraction(step.phase, step.end, hit.t) * step.h, ends_on_surface(code));
    }
    return open_guess(code, step);
}

fn segment_end(ray: Ray, hit: Hit, step: LastStep) -> PathPoint {
    if ENDS_ON_CHORDS {
        let t = select(1.0, hit.t, ray.status == HIT);
        let x = mix(ray.phase[0].xyz, step.end[0].xyz, t);
        let v = mix(ray.phase[1].xyz, step.end[1].xyz, t);
        return PathPoint(x, v, mix(ray.tau, step.end_tau, t), t);
    }
    return PathPoint(step.end[0].xyz, step.end[1].xyz, step.end_tau, 1.0);
}
