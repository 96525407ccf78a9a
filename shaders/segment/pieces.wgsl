// Divides a segment into straight pieces, which share their ends exactly, so that no ray tunnels between two; and intersects them with the
// items of an acceleration structure, in its order.

// The bits that mark the objects near a segment: one for the structure, the others for shapes in lists.
const NEAR_STRUCTURE: u32 = 0x80000000u;
const NEAR_LISTED: u32 = 0x7fffffffu;

const BELOW_ONE: Real = 0.99999994;

fn piece_start(s: Segment, k: u32, pieces: u32) -> Real3 {
    return select(segment_point(s, Real(k) / Real(pieces)), s.x0, k == 0u);
}

fn piece_end(s: Segment, k: u32, pieces: u32) -> Real3 {
    return select(segment_point(s, Real(k + 1u) / Real(pieces)), s.x1, k + 1u == pieces);
}

// Converts a fraction of piece k to a fraction of its segment.
fn segment_fraction(k: u32, pieces: u32, t: Real) -> Real {
    return min((Real(k) + clamp(t, 0.0, 1.0)) / Real(pieces), BELOW_ONE);
}

// Returns the nearer of a hit and a hit at `t`, where 2 is a miss; of two hits at the same position the lower primitive, so that the order
// in which they are found does not matter.
fn nearer_hit(hit: Hit, t: Real, primitive: u32) -> Hit {
    let nearer = t < hit.t || (t == hit.t && t < 2.0 && primitive < hit.primitive);
    return Hit(select(hit.t, t, nearer), select(hit.primitive, primitive, nearer));
}

// Returns the status of the ray after a segment: hits come first, except that nothing inside a horizon is seen.
fn segment_status(s: Segment, tau: Real, index: u32, hit: Hit) -> u32 {
    if !HAS_OBJECTS {
        return open_status(s, tau, index);
    }
    if hit.primitive == NOTHING {
        return open_status(s, tau, index);
    }
    return select(HIT, CAPTURED, law_captured(segment_point(s, hit.t), s.x1 - s.x0));
}

// The range of a segment in which its pieces may be inside a box: from the piece in which they enter to the one in which they leave.
struct Span {
    enters: Real,
    leaves: Real,
}

// The margin, in pieces, around a position at a fraction of the segment: rounding must not hide a hit.
const PIECE_SLACK: Real = 1e-2;

// Returns the piece that contains a fraction of the segment.
fn piece_at(t: Real, pieces: u32) -> u32 {
    return u32(clamp(t, 0.0, Real(pieces - 1u)));
}

// Intersects `count` items, from `first`, with the pieces of a segment that may be near them: refinement is left to the leaves.
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
