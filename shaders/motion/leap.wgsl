// Leaps through a region that contains nothing else: a segment leads to the surface of the sphere, or to its center. Elsewhere segments are
// tested against the scene.

fn leaps() -> bool {
    return IS_EMPTY;
}

fn leap_hit(s: Segment) -> Hit {
    if !IS_EMPTY {
        return Hit(2.0, NOTHING);
    }
    let d = s.x1 - media[place].center;
    // A ray tangent to the surface leaves it at once; one on a circle further in never does.
    let out = dot(d, s.v1) >= 0.0 && dot(d, d) > 0.999 * here().radius * here().radius;
    return Hit(BELOW_ONE, select(NOTHING, here().primitive, out));
}
