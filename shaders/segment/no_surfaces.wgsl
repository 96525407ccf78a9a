// There is nothing to hit.

fn nearby(s: Segment) -> u32 {
    return 0u;
}

fn first_hit(s: Segment, near: u32, pixel: vec2u) -> Hit {
    return Hit(0.0, NOTHING);
}

fn walk_turn() {
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

fn seen_at(ray: Ray, hit: Hit) -> Seen {
    return Seen(path_end(ray, hit), vec3f(0.0), vec3f(0.0), 0u);
}

fn clear_hit(pixel: vec2u) {
}

fn store_hit(pixel: vec2u, hit: Hit) {
}

fn load_hit(pixel: vec2u) -> Hit {
    return Hit(0.0, NOTHING);
}

fn recorded_at(ray: Ray, hit: Hit) -> Recorded {
    return Recorded(path_end(ray, hit), 0u);
}
