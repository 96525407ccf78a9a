// From a centre: the way to a place is all of d = x - p.

fn offset_center(d: Real3, along: Real3) -> Real3 {
    return d;
}
