// Segments are tested against the scene.

fn leaps() -> bool {
    return false;
}

fn leap_hit(s: Segment) -> Hit {
    return Hit(2.0, NOTHING);
}
