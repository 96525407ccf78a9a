// Paths are in pieces, one behind the other: hits that rounding puts just before one's start still count.

fn overlap() -> Real {
    return OVERLAP;
}
