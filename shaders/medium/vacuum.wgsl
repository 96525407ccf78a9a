// A law without an index: surfaces in it use the index of empty space.

fn medium_index(x: Real3) -> Real {
    return 1.0;
}
