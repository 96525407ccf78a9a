// The bounding sphere, in (almost) flat space, which no ray that left it re-enters (W04 §4.1).

struct Bound {
    center: Real3,
    radius: Real,
}

@group(0) @binding(60) var<uniform> bound: Bound;

fn bound_offset(x: Real3) -> Real3 {
    return x - bound.center;
}
