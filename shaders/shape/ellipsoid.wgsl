// Intersects ellipsoids, spheres scaled differently along their axes, in object space.

var<storage, read> ellipsoids: array<Placed>;
var<uniform> ellipsoid_list: array<LocalSpace, ELLIPSOID_COUNT>;

fn ellipsoid_interval(space: LocalSpace, a: Real3, d: Real3) -> Interval {
    let v = local_vector(space, d);
    return ball_interval(local_point(space, a), v, 1.0 / dot(v, v), 1.0);
}

fn hit_ellipsoid(own: LocalSpace, primitive: u32, a: Real3, d: Real3) -> Real {
    return first_end(ellipsoid_interval(own, a, d));
}

fn ellipsoid_fraction(i: u32, a: Real3, d: Real3) -> Real {
    return hit_ellipsoid(local_space(ellipsoids[i]), ELLIPSOID | i, a, d);
}

fn surface_ellipsoid(i: u32, x: Real3) -> Surface {
    let p = local_point(local_space(ellipsoids[i]), x);
    let r = length(p);
    let g = scene_gradient(local_space(ellipsoids[i]), p / r);
    let steep = length(g);
    let n = g / steep;
    return Surface((r - 1.0) / steep, 1.0 / steep, n, vec3f(n), sphere_uv(p), ellipsoids[i].material, ellipsoids[i].object);
}

// Ellipsoids that rays cross: after the opaque ones in their list.

var<uniform> sided_ellipsoid_list: array<SidedSpace, SIDED_ELLIPSOID_COUNT>;

fn cross_ellipsoid(own: SidedSpace, a: Real3, d: Real3) -> Real {
    return crossing(ellipsoid_interval(sided_space(own), a, d), own.bit);
}
