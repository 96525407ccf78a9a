// Paths are in pieces, one behind the other, as without shadows; the line to a light begins where it does.

fn overlap() -> Real {
    return select(OVERLAP, 0.0, along_light);
}
