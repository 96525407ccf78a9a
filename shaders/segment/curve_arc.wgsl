// Treats a segment as a cubic Hermite arc through its ends, cut into chords within a tolerance of it.

struct Arc {
    // The tolerance, in scene units.
    tolerance: Real,
    // The bounding box of everything that can be hit.
    lo: Real3,
    hi: Real3,
}

var<uniform> arc: Arc;

const MAX_PIECES: Real = 16.0;

// Returns `false` if the box of the arc's Bézier points misses the box of everything that can be hit.
fn may_meet_objects(s: Segment) -> bool {
    let b1 = s.x0 + (s.h / 3.0) * s.v0;
    let b2 = s.x1 - (s.h / 3.0) * s.v1;
    let lo = min(min(s.x0, s.x1), min(b1, b2));
    let hi = max(max(s.x0, s.x1), max(b1, b2));
    return all(lo <= arc.hi) && all(hi >= arc.lo);
}

// Returns the number of chords: 0 if the arc misses all objects, or if the motion has found that nothing is on the way.
fn segment_pieces(s: Segment) -> u32 {
    // An eighth of the largest second derivative, which is linear along the arc, bounds the distance between chord and curve; it falls with
    // the square of the number of pieces.
    let c = s.x1 - s.x0;
    let a = s.h * s.v0 - c;
    let b = c - s.h * s.v1;
    let sag = 0.25 * max(length(2.0 * a - b), length(a - 2.0 * b));
    let pieces = clamp(ceil(sqrt(sag / arc.tolerance)), 1.0, MAX_PIECES);
    return select(0u, u32(pieces), may_meet_objects(s) && s.h != 0.0);
}

// Returns a bound, along each axis, on the distance of the arc and its chords from the segment's chord at the same fraction: the difference
// is t (1 − t) times a value between a and b.
fn segment_bulge(s: Segment) -> Real3 {
    let c = s.x1 - s.x0;
    return 0.25 * max(abs(s.h * s.v0 - c), abs(c - s.h * s.v1));
}

fn segment_point(s: Segment, t: Real) -> Real3 {
    let c = s.x1 - s.x0;
    let u = 1.0 - t;
    return s.x0 + t * (c + u * (u * (s.h * s.v0 - c) + t * (c - s.h * s.v1)));
}
