// There is nothing to hit.

fn first_hit(s: Segment, pixel: vec2u) -> Hit {
    return Hit(0.0, NOTHING);
}

fn walk_suspended() -> bool {
    return false;
}

fn segment_fate(s: Segment, tau: Real, index: u32, hit: Hit) -> u32 {
    return open_fate(s, tau, index);
}

fn walk_needed(pixel: vec2u) -> bool {
    return true;
}

fn walk_unfinished(pixel: vec2u) -> bool {
    return false;
}
