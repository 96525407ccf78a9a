// Crossing boxes: behind the opaque ones in their list.

@group(0) @binding(68) var<uniform> sided_boxes: array<SidedSpace, SIDED_BOX_COUNT>;

fn cross_box(a: Real3, b: Real3, best: Hit) -> Hit {
    var hit = best;
    for (var i = 0u; i < SIDED_BOX_COUNT; i++) {
        work += 1u;
        let sided = sided_boxes[i];
        let own = OwnSpace(sided.row_x, sided.row_y, sided.row_z);
        let t = crossing(box_interval(own_point(own, a), own_vector(own, b - a)), sided.bit);
        if t < hit.t {
            hit = Hit(t, BOX | (BOX_COUNT + i));
        }
    }
    return hit;
}
