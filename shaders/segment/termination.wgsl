// Decides how a path ends.

// Returns `true` if the path needs no further step: it left the bounding sphere, was captured, reached its length or is not finite.
fn path_over(ray: Ray) -> bool {
    let x = ray.phase[0].xyz;
    let v = ray.phase[1].xyz;
    return !finite(x) || !finite(v) || left_bound(x, v) || law_captured(x, v) || length_reached(ray.tau);
}

// Returns the status of the ray after a segment in which it met nothing (the termination tests of W04 §4.1); `index` is the number of
// segments before it.
fn open_status(s: Segment, tau: Real, index: u32) -> u32 {
    // From the last test to the first, each overriding those before: without branches, because their masks cost more than the tests.
    var code = select(ALIVE, EXHAUSTED, index + 1u >= schedule.max_segments);
    code = select(code, STALLED, all(s.x1 == s.x0));
    code = select(code, ENDED, length_reached(tau));
    code = select(code, CAPTURED, law_captured(s.x1, s.v1));
    code = select(code, ESCAPED, left_bound(s.x1, s.v1));
    return select(FAILED, code, finite(s.x1) && finite(s.v1));
}

// Returns `true` if loops were cut short in a segment for which another pass, in which it comes first, has more room.
fn overran(segments: u32) -> bool {
    if FOLLOWS_WHOLE {
        return is_spent();
    }
    return is_spent() && segments > 0u;
}

// Returns the status of a segment, unless its loops may have been cut short: then the result is unknown.
fn known_status(code: u32) -> u32 {
    if is_spent() {
        tally_at_once(OVERRUN);
        return FAILED;
    }
    return code;
}

// Returns the ray after a pass of steps, made not finite if its loops may have been cut short.
fn known_ray(ray: Ray) -> Ray {
    var known = ray;
    if is_spent() {
        tally_at_once(OVERRUN);
        known.phase[0] *= infinite();
        known.phase[1] *= infinite();
    }
    return known;
}
