// The bounding sphere, in (almost) flat space, which no ray that left it re-enters (W04 §4.1). On either side of a wormhole: as far round
// the other mouth as round this one.

struct Bound {
    center: Real3,
    radius: Real,
}

var<uniform> bound: Bound;

// From the middle of the nearer one.
fn bound_offset(x: Real3) -> Real3 {
    let here = x - bound.center;
    if !HAS_THROAT {
        return here;
    }
    let there = here - (law.other - law.center);
    return select(here, there, dot(there, there) < dot(here, here));
}
