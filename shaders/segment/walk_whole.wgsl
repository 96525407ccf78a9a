// A segment's walk over the scene is short enough to be done in one go.

fn walked_hit(s: Segment, near: u32, pixel: vec2u) -> Hit {
    let pieces = segment_pieces(s);
    let hit = structure_hit(s, select(0u, pieces, (near & NEAR_STRUCTURE) != 0u), listed_hit(s, pieces, near));
    return Hit(select(hit.t, 0.0, hit.primitive == NOTHING), hit.primitive);
}

fn walk_begin() -> u32 {
    return 0u;
}

fn walk_has_room() -> bool {
    return true;
}

fn walk_stop(place: u32, done: bool) {
}

fn walk_suspended() -> bool {
    return false;
}

fn walk_needed(pixel: vec2u) -> bool {
    return true;
}

fn walk_unfinished(pixel: vec2u) -> bool {
    return false;
}
