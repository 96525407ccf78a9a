// Crossing cylinders: behind the opaque ones in their list.

@group(0) @binding(63) var<uniform> sided_cylinders: array<SidedSpace, SIDED_CYLINDER_COUNT>;

fn cross_cylinder(a: Real3, b: Real3, best: Hit) -> Hit {
    var hit = best;
    for (var i = 0u; i < SIDED_CYLINDER_COUNT; i++) {
        work += 1u;
        let sided = sided_cylinders[i];
        let own = OwnSpace(sided.row_x, sided.row_y, sided.row_z);
        let t = crossing(cylinder_interval(own_point(own, a), own_vector(own, b - a)), sided.bit);
        if t < hit.t {
            hit = Hit(t, CYLINDER | (CYLINDER_COUNT + i));
        }
    }
    return hit;
}
