// Nothing else is in the region: a segment leads to the sphere that it is in, or into the middle.

fn leaps() -> bool {
    return true;
}

fn leap_hit(s: Segment) -> Hit {
    let d = s.x1 - media[place].center;
    // A ray along the surface leaves it where it is; one in a circle further in never does.
    let out = dot(d, s.v1) >= 0.0 && dot(d, d) > 0.999 * here().radius * here().radius;
    return Hit(BELOW_ONE, select(NOTHING, here().primitive, out));
}
