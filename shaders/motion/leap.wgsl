// A region in which nothing else is: there a segment leads to the sphere that it is in, or into the middle, and elsewhere segments are
// tested against the scene.

fn leaps() -> bool {
    return IS_EMPTY;
}

fn leap_hit(s: Segment) -> Hit {
    if !IS_EMPTY {
        return Hit(2.0, NOTHING);
    }
    let d = s.x1 - media[place].center;
    // A ray along the surface leaves it where it is; one in a circle further in never does.
    let out = dot(d, s.v1) >= 0.0 && dot(d, d) > 0.999 * here().radius * here().radius;
    return Hit(BELOW_ONE, select(NOTHING, here().primitive, out));
}
