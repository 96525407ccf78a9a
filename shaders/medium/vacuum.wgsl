// A law that has no index: surfaces in it see that of empty space.

fn medium_index(x: Real3) -> Real {
    return 1.0;
}
