// Nothing else is in the region: a segment leads to the sphere that it is in, or into the middle.

fn leaps() -> bool {
    return true;
}

fn leap_hit(s: Segment) -> Hit {
    let outward = dot(s.x1 - media[place].center, s.v1) > 0.0;
    return Hit(BELOW_ONE, select(NOTHING, here().primitive, outward));
}
