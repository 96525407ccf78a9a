// Crossing cylinders: behind the opaque ones in their list.

@group(0) @binding(63) var<uniform> sided_cylinder_list: array<SidedSpace, SIDED_CYLINDER_COUNT>;

fn cross_cylinder(own: SidedSpace, a: Real3, d: Real3) -> Real {
    let space = sided_space(own);
    return crossing(cylinder_interval(own_point(space, a), own_vector(space, d)), own.bit);
}
