// How a path ends, and where exactly.

// The path needs no further step: it left the bound, was captured, reached its length or is not finite.
fn path_over(ray: Ray) -> bool {
    let x = ray.phase[0].xyz;
    let v = ray.phase[1].xyz;
    return !finite(x) || !finite(v) || left_bound(x, v) || law_captured(x, v) || length_reached(ray.tau);
}

// The ray's status after a segment in which it met nothing (W04 §4.1's tests for termination): index segments lie before it.
fn open_status(s: Segment, tau: Real, index: u32) -> u32 {
    // From the last test to the first, each overriding those before: without branches, whose masks cost more than the tests.
    var code = select(ALIVE, EXHAUSTED, index + 1u >= schedule.max_segments);
    code = select(code, STALLED, all(s.x1 == s.x0));
    code = select(code, ENDED, length_reached(tau));
    code = select(code, CAPTURED, law_captured(s.x1, s.v1));
    code = select(code, ESCAPED, left_bound(s.x1, s.v1));
    return select(FAILED, code, finite(s.x1) && finite(s.v1));
}

// Were loops cut short in a segment for which another pass has more room? That is one in which it comes first.
fn overran(segments: u32) -> bool {
    if FOLLOWS_WHOLE {
        return is_spent();
    }
    return is_spent() && segments > 0u;
}

// A segment's status, unless its loops may have been cut short: then what it came to is not known.
fn known_status(code: u32) -> u32 {
    if is_spent() {
        tally_at_once(OVERRUN);
        return FAILED;
    }
    return code;
}

// The ray after a pass of steps, in the same way: not finite.
fn known_ray(ray: Ray) -> Ray {
    var known = ray;
    if is_spent() {
        tally_at_once(OVERRUN);
        known.phase[0] *= infinite();
        known.phase[1] *= infinite();
    }
    return known;
}
