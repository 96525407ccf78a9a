// A segment as straight pieces, which share their ends exactly, so that no ray tunnels between two; and the items that a structure
// holds, in the order that it keeps them in, against them.

// Of the bits that say what a segment is near: the structure's, and those of shapes in lists.
const NEAR_STRUCTURE: u32 = 0x80000000u;
const NEAR_LISTED: u32 = 0x7fffffffu;

const BELOW_ONE: Real = 0.99999994;

fn piece_start(s: Segment, k: u32, pieces: u32) -> Real3 {
    return select(segment_point(s, Real(k) / Real(pieces)), s.x0, k == 0u);
}

fn piece_end(s: Segment, k: u32, pieces: u32) -> Real3 {
    return select(segment_point(s, Real(k + 1u) / Real(pieces)), s.x1, k + 1u == pieces);
}

// A fraction of piece k as one of its segment.
fn segment_fraction(k: u32, pieces: u32, t: Real) -> Real {
    return min((Real(k) + clamp(t, 0.0, 1.0)) / Real(pieces), BELOW_ONE);
}

// The nearer of a hit and what is met at `t`, or missed where that is 2; of two at the same place the lesser primitive, so that
// the order in which they are found does not matter.
fn nearer_hit(hit: Hit, t: Real, primitive: u32) -> Hit {
    let nearer = t < hit.t || (t == hit.t && t < 2.0 && primitive < hit.primitive);
    return Hit(select(hit.t, t, nearer), select(hit.primitive, primitive, nearer));
}

// The ray's status after a segment: hits come first, except that what lies inside a horizon is not seen.
fn segment_status(s: Segment, tau: Real, index: u32, hit: Hit) -> u32 {
    if !HAS_OBJECTS {
        return open_status(s, tau, index);
    }
    if hit.primitive == NOTHING {
        return open_status(s, tau, index);
    }
    return select(HIT, CAPTURED, law_captured(segment_point(s, hit.t), s.x1 - s.x0));
}

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
        let a = piece_start(s, k, pieces);
        let d = piece_end(s, k, pieces) - a;
        for (var i = 0u; i < count; i++) {
            let item = item_at(first + i);
            let t = item_fraction(item, a, d);
            hit = nearer_hit(hit, select(segment_fraction(k, pieces, t), 2.0, t > 1.5), item);
        }
        k += 1u;
    }
    return hit;
}
