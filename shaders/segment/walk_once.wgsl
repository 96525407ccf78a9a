// A segment's walk over the scene's structure may need more iterations than a pass has, and no later pass goes on with it: where the
// work runs out the ray stays alive, and the host follows it by other passes.

var<private> walk_stopped: bool;

fn walk_begin() -> u32 {
    return 0u;
}

// There is room for the next place, and for all that follows the walk.
fn walk_has_room() -> bool {
    return work + schedule.segment_work < WORK_LIMIT;
}

fn walk_stop(place: u32, done: bool) {
    walk_stopped = !done;
}

fn walked_hit(s: Segment, near: u32, pixel: vec2u) -> Hit {
    let pieces = segment_pieces(s);
    let sought = select(0u, pieces, (near & NEAR_STRUCTURE) != 0u);
    let hit = structure_hit(s, sought, listed_hit(s, pieces, near));
    return Hit(select(hit.t, 0.0, hit.primitive == NOTHING), hit.primitive);
}

fn walk_suspended() -> bool {
    return walk_stopped;
}

fn walk_needed(pixel: vec2u) -> bool {
    return true;
}

fn walk_unfinished(pixel: vec2u) -> bool {
    return false;
}
