// Shapes of which there are few, in lists: those that are near, one after the other, each against the pieces up to the first that
// meets it. A processor leaves the loop at once where no ray beside this one has any.

fn listed_hit(s: Segment, pieces: u32, near: u32) -> Hit {
    var hit = Hit(2.0, NOTHING);
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
    return hit;
}
