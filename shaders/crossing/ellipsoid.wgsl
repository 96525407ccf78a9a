// Crossing ellipsoids: behind the opaque ones in their list.

@group(0) @binding(67) var<uniform> sided_ellipsoids: array<SidedSpace, SIDED_ELLIPSOID_COUNT>;

fn cross_ellipsoid(a: Real3, b: Real3, best: Hit) -> Hit {
    var hit = best;
    for (var i = 0u; i < SIDED_ELLIPSOID_COUNT; i++) {
        work += 1u;
        let sided = sided_ellipsoids[i];
        let own = OwnSpace(sided.row_x, sided.row_y, sided.row_z);
        let d = own_vector(own, b - a);
        let t = crossing(ball_interval(own_point(own, a), d, 1.0 / dot(d, d), 1.0), sided.bit);
        if t < hit.t {
            hit = Hit(t, ELLIPSOID | (ELLIPSOID_COUNT + i));
        }
    }
    return hit;
}
