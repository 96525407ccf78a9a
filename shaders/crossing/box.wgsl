// Crossing boxes: behind the opaque ones in their list.

@group(0) @binding(68) var<uniform> sided_boxes: array<SidedSpace, SIDED_BOX_COUNT>;

fn box_span(p: Real3, d: Real3) -> Real2 {
    // A component that is 0 gets a slab that is entered at −∞ and left at +∞, or never.
    let inverse = 1.0 / select(d, Real3(1e-30), d == Real3(0.0));
    let near = -p * inverse - abs(inverse);
    let far = -p * inverse + abs(inverse);
    let span = Real2(max(max(near.x, near.y), near.z), min(min(far.x, far.y), far.z));
    return select(no_span(), span, span.x < span.y);
}

fn cross_box(a: Real3, b: Real3, best: Hit) -> Hit {
    var hit = best;
    for (var i = 0u; i < SIDED_BOX_COUNT; i++) {
        work += 1u;
        let sided = sided_boxes[i];
        let own = OwnSpace(sided.row_x, sided.row_y, sided.row_z);
        let t = crossing(box_span(own_point(own, a), own_vector(own, b - a)), sided.bit);
        if t < hit.t {
            hit = Hit(t, BOX | (BOX_COUNT + i));
        }
    }
    return hit;
}
