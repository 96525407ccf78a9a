// A segment's walk over the scene is short enough to be done in one go.

fn walked_hit(s: Segment, pixel: vec2u) -> Hit {
    let pieces = segment_pieces(s);
    var hit = Hit(0.0, NOTHING);
    var a = s.x0;
    for (var k = 0u; k < pieces && hit.primitive == NOTHING; k++) {
        work += 1u;
        let b = piece_end(s, k, pieces);
        hit = piece_hit(a, b, Hit(2.0, NOTHING));
        hit.t = segment_fraction(k, pieces, hit.t);
        a = b;
    }
    return hit;
}

fn walk_begin() -> u32 {
    return 0u;
}

fn walk_may_go_on() -> bool {
    return true;
}

fn walk_stop(node: u32, count: u32) {
}

fn walk_suspended() -> bool {
    return false;
}

fn walk_needed(pixel: vec2u) -> bool {
    return true;
}
