// The edge is within the bounding sphere, which lies off the centre: paths go on across it by steps like any other.

fn left_size(o: Orbit, s: Real, edge: Real) -> Real {
    return s;
}

fn orbit_left(o: Orbit, over: Orbit, edge: Real) -> Orbit {
    return over;
}
