// Surfaces that rays go on from are met from the side that a ray is known to be on: from outside it enters, from inside it
// leaves. A ray that was just refracted or reflected lies on the surface only up to rounding, but cannot meet it in the other
// direction; so no distance has to be kept from it, and what rounding lets slip is mended: who is outside although the set says
// inside leaves at once, and who is inside and moves further in enters.

// A convex shape in its own space, and the object's bit in the set of regions.
struct SidedSpace {
    row_x: Real4,
    row_y: Real4,
    row_z: Real4,
    bit: u32,
}

fn sided_space(own: SidedSpace) -> OwnSpace {
    return OwnSpace(own.row_x, own.row_y, own.row_z);
}

fn is_inside(bit: u32) -> bool {
    return ((inside >> bit) & 1u) == 1u;
}

// The fraction at which a piece crosses a convex surface, or 2. span: where the piece's line is inside it.
fn crossing(span: Interval, bit: u32) -> Real {
    let missed = span.enters > span.leaves;
    let leaves = select(max(span.leaves, 0.0), 0.0, missed);
    let ahead = !missed && span.leaves > 0.0 && span.enters + span.leaves > 0.0;
    let t = select(select(2.0, max(span.enters, 0.0), ahead), leaves, is_inside(bit));
    return select(2.0, t, t <= 1.0 + OVERLAP);
}
