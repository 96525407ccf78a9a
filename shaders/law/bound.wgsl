// The bounding sphere, in (almost) flat space, which no ray that left it re-enters (W04 §4.1). A wormhole has one of equal radius around
// each mouth.

struct Bound {
    center: Real3,
    radius: Real,
}

var<uniform> bound: Bound;

// Returns the position of x relative to the center of the nearer sphere.
fn bound_offset(x: Real3) -> Real3 {
    let here = x - bound.center;
    if !HAS_THROAT {
        return here;
    }
    let there = here - (law.other - law.center);
    return select(here, there, dot(there, there) < dot(here, here));
}
