// There is nothing to hit.

fn first_hit(s: Segment, pixel: vec2u) -> Hit {
    return Hit(0.0, NOTHING);
}

fn walk_suspended() -> bool {
    return false;
}

fn segment_status(s: Segment, tau: Real, index: u32, hit: Hit) -> u32 {
    return open_status(s, tau, index);
}

fn walk_needed(pixel: vec2u) -> bool {
    return true;
}

fn walk_unfinished(pixel: vec2u) -> bool {
    return false;
}

fn seen_at(ray: Ray, pixel: vec2u) -> Seen {
    return Seen(path_end(ray, Hit(0.0, NOTHING)), vec3f(0.0), vec3f(0.0), 0u);
}

fn clear_hit(pixel: vec2u) {
}

fn store_hit(pixel: vec2u, hit: Hit) {
}

fn load_hit(pixel: vec2u) -> Hit {
    return Hit(0.0, NOTHING);
}

fn recorded_at(ray: Ray, pixel: vec2u) -> Recorded {
    return Recorded(path_end(ray, Hit(0.0, NOTHING)), 0u);
}
