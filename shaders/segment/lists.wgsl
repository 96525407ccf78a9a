// Intersects a segment with the shapes that are in lists because there are few of them: returns the fraction of the segment at the first
// hit, or 2. Near shapes are tested one after the other, each against the pieces up to the first hit (on a CPU the loop ends at once if no
// lane has one); or, if no shape is excluded beforehand, each against every piece, up to the first that has a hit.

fn listed_hit(s: Segment, pieces: u32, near: u32) -> Hit {
    var hit = Hit(2.0, NOTHING);
    if !HAS_LISTS {
        return hit;
    }
    if FINDS_NEAR {
        var left = select(0u, near & NEAR_LISTED, pieces > 0u);
        while left != 0u {
            let item = firstTrailingBit(left);
            left &= left - 1u;
            var a = s.x0;
            var t: Real = 2.0;
            for (var k = 0u; k < pieces && t > 1.5; k++) {
                let b = piece_end(s, k, pieces);
                t = listed_fraction(item, a, b - a);
                t = select(segment_fraction(k, pieces, t), 2.0, t > 1.5);
                a = b;
            }
            hit = nearer_hit(hit, t, listed_primitive(item));
        }
    } else {
        var a = s.x0;
        for (var k = 0u; k < pieces && hit.primitive == NOTHING; k++) {
            let b = piece_end(s, k, pieces);
            hit = piece_hit(a, b, Hit(2.0, NOTHING));
            hit.t = select(segment_fraction(k, pieces, hit.t), 2.0, hit.primitive == NOTHING);
            a = b;
        }
    }
    return hit;
}
