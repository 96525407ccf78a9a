// How far before a piece's start rounding may put a hit that still counts, where paths are in pieces, one behind the other. What is behind
// the start of a straight path, at the camera or on a surface, is not hit; nor what is behind the surface that a path or a line to a light
// has left.

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
