// Finds the objects that a segment may meet. The bounding sphere of each shape in a list, and the one of the whole acceleration structure,
// are compared with the segment's chord at once, without a branch. The segment and its pieces are, at each fraction, within its bulge of
// the chord, by which the spheres are grown. Objects that are not near need no further test; nearly always that is nearly all of them.

struct Surrounding {
    center: Real3,
    radius: Real,
    // The unit normal of a flat shape, else 0.
    normal: Real3,
}

var<uniform> surroundings: array<Surrounding, NEAR_COUNT>;

// The effect of rounding, relative to the distances that a test uses.
const NEAR_SLACK: Real = 4e-6;

// The chord of a segment.
struct Chordal {
    a: Real3,
    d: Real3,
    inverse_dd: Real,
    // The distance by which the bounding spheres are grown.
    margin: Real,
}

fn chordal(s: Segment) -> Chordal {
    let d = s.x1 - s.x0;
    let dd = dot(d, d);
    let margin = length(segment_bulge(s)) + NEAR_SLACK * (length(s.x0) + sqrt(dd));
    return Chordal(s.x0, d, 1.0 / max(dd, 1e-30), margin);
}

// Written so that NaN counts as near.
fn near_ball(own: Surrounding, c: Chordal) -> bool {
    let way = own.center - c.a;
    let t = clamp(dot(way, c.d) * c.inverse_dd, -OVERLAP, 1.0 + OVERLAP);
    let miss = way - t * c.d;
    let reach = own.radius + c.margin;
    return !(dot(miss, miss) > reach * reach);
}

// Flat shapes fill their bounding spheres badly: the chord must also come near their plane.
fn near_flat(own: Surrounding, c: Chordal) -> bool {
    let first = dot(c.a - own.center, own.normal);
    let second = first + dot(c.d, own.normal);
    // The distances of the ends, and the length of the chord for pieces that extend beyond their ends.
    let slack = c.margin + NEAR_SLACK * own.radius + OVERLAP * abs(second - first);
    return near_ball(own, c) && !(max(first, second) < -slack) && !(min(first, second) > slack);
}
