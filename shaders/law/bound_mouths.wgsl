// The bounding sphere on either side of a wormhole: as far round the other mouth as round this one.

struct Bound {
    center: Real3,
    radius: Real,
}

@group(0) @binding(60) var<uniform> bound: Bound;

// From the middle of the nearer one.
fn bound_offset(x: Real3) -> Real3 {
    let here = x - bound.center;
    let there = here - (law.other - law.center);
    return select(here, there, dot(there, there) < dot(here, here));
}
