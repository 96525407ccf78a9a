// Computes how far before the start of a piece rounding may put a hit that still counts, if paths are in contiguous pieces. A hit before
// the start of a straight path, at the camera or on a surface, does not count; nor does a hit behind the surface that a path or a line to a
// light has left.

fn overlap() -> Real {
    if IS_WHOLE {
        return 0.0;
    }
    if FOLLOWS_PATHS {
        return select(OVERLAP, 0.0, last_primitive != NOTHING);
    } else if LOOKS_FROM_SURFACES {
        return select(OVERLAP, 0.0, along_light);
    } else {
        return OVERLAP;
    }
}
