// Crossing boxes: behind the opaque ones in their list.

@group(0) @binding(68) var<uniform> sided_box_list: array<SidedSpace, SIDED_BOX_COUNT>;

fn cross_box(own: SidedSpace, a: Real3, d: Real3) -> Real {
    let space = sided_space(own);
    return crossing(box_interval(own_point(space, a), own_vector(space, d)), own.bit);
}
