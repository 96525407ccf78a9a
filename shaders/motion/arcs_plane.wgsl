// Steps in the plane of an orbit that a cubic is to follow: as long as any.

fn orbit_arc_stride(o: Orbit, eta: Real, size: Real) -> Real {
    return orbit_stride(o, eta, size);
}
