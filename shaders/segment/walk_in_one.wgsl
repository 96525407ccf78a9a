// A segment's walk over the scene begins and ends in one pass.

fn walk_begin() -> u32 {
    return 0u;
}

fn walked_hit(s: Segment, near: u32, pixel: vec2u) -> Hit {
    let pieces = segment_pieces(s);
    let sought = select(0u, pieces, (near & NEAR_STRUCTURE) != 0u);
    let hit = structure_hit(s, sought, listed_hit(s, pieces, near));
    return Hit(select(hit.t, 0.0, hit.primitive == NOTHING), hit.primitive);
}

fn walk_needed(pixel: vec2u) -> bool {
    return true;
}

fn walk_unfinished(pixel: vec2u) -> bool {
    return false;
}
