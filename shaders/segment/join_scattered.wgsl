// Paths are in pieces, one behind the other, and hits that rounding puts just before one's start still count; but a path begins where it
// left a surface, and what is behind that is not hit.

fn overlap() -> Real {
    return select(OVERLAP, 0.0, last_primitive != NOTHING);
}
