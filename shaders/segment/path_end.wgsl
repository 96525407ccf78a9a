// Finds where a path ends, once per ray after all segments: on a surface, on the bounding sphere, or at the horizon.

const STOP_STEPS: u32 = 4u;

// Returns the outward normal and the signed distance of the sphere at which a ray that met nothing stops.
fn open_gap(code: u32, x: Real3) -> Real4 {
    let d = bound_offset(x);
    let r = length(d);
    return select(capture_gap(x), Real4(d / r, r - bound.radius), code == ESCAPED);
}

// Retakes the step so that it ends where the ray stops, by the Newton method. The position and direction of the arc itself would be off by
// up to 3e-4.
fn stop_point(code: u32, hit: Hit, step: LastStep) -> PathPoint {
    var h = first_guess(code, hit, step);
    if IN_PIECES {
        pass_top(code, hit, step, &h);
    }
    var p: Phase;
    var settled = false;
    var unfinished = true;
    // The loop begins with the step, so that the code contains it once: drivers repeat the code of every call. It has no `break`, after which
    // Mesa's software driver went on changing h (22.3.6).
    for (var i = 0u; unfinished; i++) {
        p = retaken_step(step.phase, h);
        if TRAVELS {
            note_passage(p, step.tau + own_tau(step.phase, p, h));
        }
        unfinished = !settled && i < STOP_STEPS;
        if unfinished {
            let surface = stop_distance(code, hit, p[0].xyz);
            let slope = dot(surface.xyz, p[1].xyz);
            let steep = abs(slope) > 1e-3 * length(p[1].xyz);
            let correction = select(0.0, surface.w / (slope * own_pace(p)), steep);
            h = clamp(h - correction, 0.0, step.h);
            // Straight lines and leaps converge at once.
            settled = abs(correction) <= LAST_PART * step.h;
        }
    }
    if FOLLOWS_SHIFT {
        note_end(p);
    }
    let tau = step.tau + own_tau(step.phase, p, h);
    let far = departed(code, p[0].xyz, p[1].xyz);
    return PathPoint(far[0], far[1], tau, h / max(step.h, 1e-30));
}

// Returns the fraction at which the gap of a ray that met nothing vanishes if it is linear along the step; the end of the step if the gap
// keeps its sign.
fn secant_guess(code: u32, step: LastStep) -> Real {
    let g0 = open_gap(code, step.phase[0].xyz).w;
    let g1 = open_gap(code, step.end[0].xyz).w;
    return select(step.h, step.h * g0 / (g0 - g1), (g0 < 0.0) != (g1 < 0.0));
}

// Returns the distance along v at which the line from the step's start leaves the bounding sphere.
fn line_exit(p: Phase) -> Real {
    let d = bound_offset(p[0].xyz);
    let v = p[1].xyz;
    let vv = dot(v, v);
    let b = dot(d, v) / vv;
    let miss = d - b * v;
    return sqrt(max(bound.radius * bound.radius - dot(miss, miss), 0.0) / vv) - b;
}

// A ray that first moves inwards comes nearer before it leaves: there the Newton method would return to the point where it came in.
fn open_guess(code: u32, step: LastStep) -> Real {
    let inwards = dot(bound_offset(step.phase[0].xyz), step.phase[1].xyz) < 0.0;
    return select(secant_guess(code, step), min(own_measure(step.phase, line_exit(step.phase)), step.h), code == ESCAPED && inwards);
}

// ray: the state at the start of its last segment, which is followed again to its exact end, unless the last step of a path ends there.
fn path_end(ray: Ray, hit: Hit) -> PathPoint {
    let x = ray.phase[0].xyz;
    let v = ray.phase[1].xyz;
    var unfollowed = ray.status == ALIVE || ray.status == MISSED || ray.status == OUTSIDE;
    if ENDS_WITH_STEPS {
        unfollowed = unfollowed || ray.status == FAILED;
    }
    let nowhere = unfollowed || (ray.status == CAPTURED && law_captured(x, v));
    if nowhere {
        if FOLLOWS_SHIFT {
            note_end(ray.phase);
        }
        let far = departed(ray.status, x, v);
        return PathPoint(far[0], far[1], ray.tau, 0.0);
    }
    let step = last_step(ray);
    if ENDS_WITH_STEPS {
        let far = departed(ray.status, step.end[0].xyz, step.end[1].xyz);
        return PathPoint(far[0], far[1], step.end_tau, 1.0);
    }
    if stops_inside(ray.status) {
        return stop_point(ray.status, hit, step);
    }
    if FOLLOWS_SHIFT {
        note_end(step.end);
    }
    return segment_end(ray, hit, step);
}
