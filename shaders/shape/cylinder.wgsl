// Intersects closed cylinders about y, lateral surface and both caps, in object space.

var<storage, read> cylinders: array<Placed>;
var<uniform> cylinder_list: array<LocalSpace, CYLINDER_COUNT>;

// Returns the interval in the unit cylinder itself: p and v are in object space.
fn cylinder_interval(p: Real3, v: Real3) -> Interval {
    // A piece that moves less than 1e-15 across the axis counts as parallel to it: the square of its motion might be 0.
    let across = Real3(v.x, 0.0, v.z);
    let vv = dot(across, across);
    let along = vv < 1e-30;
    let inverse_vv = 1.0 / select(vv, 1e-30, along);
    let mantle = ball_interval(Real3(p.x, 0.0, p.z), select(across, Real3(0.0), along), inverse_vv, 1.0);
    return both_inside(mantle, slab_interval(p.y, v.y));
}

fn hit_cylinder(own: LocalSpace, primitive: u32, a: Real3, d: Real3) -> Real {
    return first_end(cylinder_interval(local_point(own, a), local_vector(own, d)));
}

fn cylinder_fraction(i: u32, a: Real3, d: Real3) -> Real {
    return hit_cylinder(local_space(cylinders[i]), CYLINDER | i, a, d);
}

fn surface_cylinder(i: u32, x: Real3) -> Surface {
    let p = local_point(local_space(cylinders[i]), x);
    let rho = length(p.xz);
    // The lateral surface, or a cap: whichever is farther out.
    let flat = abs(p.y) > rho;
    let side = select(Real(-1.0), Real(1.0), p.y > 0.0);
    let out = select(Real3(p.x, 0.0, p.z) / rho, Real3(0.0, side, 0.0), flat);
    let g = scene_gradient(local_space(cylinders[i]), out);
    let steep = length(g);
    let n = g / steep;
    let v = select(0.5 + 0.5 * p.y, select(rho, 1.0 - rho, p.y > 0.0), flat);
    let uv = vec2f(turn_round(p), f32(v));
    let signed_distance = (max(abs(p.y), rho) - 1.0) / steep;
    return Surface(signed_distance, 1.0 / steep, n, vec3f(n), uv, cylinders[i].material, cylinders[i].object);
}

// Cylinders that rays cross: after the opaque ones in their list.

var<uniform> sided_cylinder_list: array<SidedSpace, SIDED_CYLINDER_COUNT>;

fn cross_cylinder(own: SidedSpace, a: Real3, d: Real3) -> Real {
    let space = sided_space(own);
    return crossing(cylinder_interval(local_point(space, a), local_vector(space, d)), own.bit);
}
