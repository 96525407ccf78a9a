// What a segment may meet: of each shape in a list a ball about it, of the structure one about all of it, held against the
// segment's chord at once, without a branch. The segment and its pieces stay, at each fraction, within its bulge of the chord, by
// which the balls are grown. What is not near is looked at no more: that is nearly everything, nearly always.

struct Surrounding {
    center: Real3,
    radius: Real,
    // Of flat shapes the unit normal, else 0.
    across: Real3,
}

var<uniform> surroundings: array<Surrounding, NEAR_COUNT>;

// What rounding may hide, as a part of the distances that a test is made of.
const NEAR_SLACK: Real = 4e-6;

// A segment's chord.
struct Chordal {
    a: Real3,
    d: Real3,
    inverse_dd: Real,
    // By how much the balls are grown.
    margin: Real,
}

fn chordal(s: Segment) -> Chordal {
    let d = s.x1 - s.x0;
    let dd = dot(d, d);
    let margin = length(segment_bulge(s)) + NEAR_SLACK * (length(s.x0) + sqrt(dd));
    return Chordal(s.x0, d, 1.0 / max(dd, 1e-30), margin);
}

// Written so that what is no number is near.
fn near_ball(own: Surrounding, c: Chordal) -> bool {
    let way = own.center - c.a;
    let t = clamp(dot(way, c.d) * c.inverse_dd, -OVERLAP, 1.0 + OVERLAP);
    let miss = way - t * c.d;
    let reach = own.radius + c.margin;
    return !(dot(miss, miss) > reach * reach);
}

// Flat shapes fill their balls badly: the chord must come near their plane too.
fn near_flat(own: Surrounding, c: Chordal) -> bool {
    let first = dot(c.a - own.center, own.across);
    let second = first + dot(c.d, own.across);
    // The ends' distances, and the length of the chord for pieces that go on beyond their ends.
    let slack = c.margin + NEAR_SLACK * own.radius + OVERLAP * abs(second - first);
    return near_ball(own, c) && !(max(first, second) < -slack) && !(min(first, second) > slack);
}
