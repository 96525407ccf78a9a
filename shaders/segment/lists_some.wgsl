// Shapes of which there are few, in lists: each against every piece, up to the first that has a hit. The fraction of the segment, or
// 2.

fn listed_hit(s: Segment, pieces: u32, near: u32) -> Hit {
    var hit = Hit(2.0, NOTHING);
    var a = s.x0;
    for (var k = 0u; k < pieces && hit.primitive == NOTHING; k++) {
        let b = piece_end(s, k, pieces);
        hit = piece_hit(a, b, Hit(2.0, NOTHING));
        hit.t = select(segment_fraction(k, pieces, hit.t), 2.0, hit.primitive == NOTHING);
        a = b;
    }
    return hit;
}
