// What a line or path that light is looked for along meets first on one segment.

fn first_met(s: Segment, pieces: u32) -> Hit {
    let near = items_near(s);
    var hit = listed_hit(s, pieces, near);
    walk_anew();
    hit = structure_hit(s, select(0u, pieces, (near & NEAR_STRUCTURE) != 0u), hit);
    unfinished = unfinished || walk_suspended();
    return hit;
}
