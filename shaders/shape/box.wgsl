// Intersects boxes, by slabs in object space.

var<storage, read> boxes: array<Placed>;
var<uniform> box_list: array<LocalSpace, BOX_COUNT>;

// Returns the interval in the cube itself: p and v are in object space.
fn box_interval(p: Real3, v: Real3) -> Interval {
    return both_inside(both_inside(slab_interval(p.x, v.x), slab_interval(p.y, v.y)), slab_interval(p.z, v.z));
}

// Returns the fraction at which the piece from a along d meets a box of the acceleration structure, or 2. Every shape has such a function.
fn hit_box(own: LocalSpace, primitive: u32, a: Real3, d: Real3) -> Real {
    return first_end(box_interval(local_point(own, a), local_vector(own, d)));
}

fn box_fraction(i: u32, a: Real3, d: Real3) -> Real {
    return hit_box(local_space(boxes[i]), BOX | i, a, d);
}

fn surface_box(i: u32, x: Real3) -> Surface {
    let p = local_point(local_space(boxes[i]), x);
    let size = abs(p);
    var axis = select(Real3(0.0, 1.0, 0.0), Real3(1.0, 0.0, 0.0), size.x > size.y);
    axis = select(axis, Real3(0.0, 0.0, 1.0), size.z > max(size.x, size.y));
    let side = sign(dot(p, axis));
    let g = scene_gradient(local_space(boxes[i]), side * axis);
    let steep = length(g);
    let n = g / steep;
    // The image on each face is upright and unmirrored as seen from outside.
    var uv = Real2(side * p.z * -1.0, p.y);
    uv = select(uv, Real2(p.x, -side * p.z), axis.y > 0.0);
    uv = select(uv, Real2(side * p.x, p.y), axis.z > 0.0);
    let signed_distance = (side * dot(p, axis) - 1.0) / steep;
    return Surface(signed_distance, 1.0 / steep, n, vec3f(n), vec2f(0.5 + 0.5 * uv), boxes[i].material, boxes[i].object);
}

// Boxes that rays cross: after the opaque ones in their list.

var<uniform> sided_box_list: array<SidedSpace, SIDED_BOX_COUNT>;

fn cross_box(own: SidedSpace, a: Real3, d: Real3) -> Real {
    let space = sided_space(own);
    return crossing(box_interval(local_point(space, a), local_vector(space, d)), own.bit);
}
