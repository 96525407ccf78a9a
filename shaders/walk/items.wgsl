// What a structure holds: primitives, in the order that it keeps them in.

// Where along a segment its pieces may be inside a box: from the one in which they enter to the one in which they leave.
struct Span {
    enters: Real,
    leaves: Real,
}

// A place at a fraction of the segment is looked for this much sooner and later, in pieces: rounding may hide no hit.
const PIECE_SLACK: Real = 1e-2;

// The piece that a fraction of the segment lies in.
fn piece_at(t: Real, pieces: u32) -> u32 {
    return u32(clamp(t, 0.0, Real(pieces - 1u)));
}

// Some items, from `first`, against the pieces of a segment that may be near them: refinement is left to the leaves.
fn items_hit(s: Segment, pieces: u32, span: Span, first: u32, count: u32, nearest: Hit) -> Hit {
    var hit = nearest;
    let last = piece_at(span.leaves * Real(pieces) + PIECE_SLACK, pieces);
    var k = piece_at(span.enters * Real(pieces) - PIECE_SLACK, pieces);
    while k <= last && count > 0u {
        work += 1u;
        let a = piece_start(s, k, pieces);
        let d = piece_end(s, k, pieces) - a;
        for (var i = 0u; i < count; i++) {
            work += 1u;
            let item = item_at(first + i);
            let t = item_fraction(item, a, d);
            hit = nearer_hit(hit, select(segment_fraction(k, pieces, t), 2.0, t > 1.5), item);
        }
        k += 1u;
    }
    return hit;
}
