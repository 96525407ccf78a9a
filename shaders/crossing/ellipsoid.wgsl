// Crossing ellipsoids: behind the opaque ones in their list.

@group(0) @binding(67) var<uniform> sided_ellipsoid_list: array<SidedSpace, SIDED_ELLIPSOID_COUNT>;

fn cross_ellipsoid(own: SidedSpace, a: Real3, d: Real3) -> Real {
    return crossing(ellipsoid_interval(sided_space(own), a, d), own.bit);
}
