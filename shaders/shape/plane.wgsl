// Intersects flat rectangles: the square |x|, |z| ≤ 1 of y = 0 in object space.

var<storage, read> planes: array<Placed>;
var<uniform> plane_list: array<LocalSpace, PLANE_COUNT>;

fn square_fraction(space: LocalSpace, a: Real3, v: Real3) -> Real {
    let p = local_point(space, a);
    let d = local_vector(space, v);
    let t = -p.y / d.y;
    let q = abs(p.xz + t * d.xz);
    return select(2.0, t, d.y != 0.0 && t >= -overlap() && t <= 1.0 + OVERLAP && max(q.x, q.y) <= 1.0);
}

fn hit_plane(own: LocalSpace, primitive: u32, a: Real3, d: Real3) -> Real {
    return select(square_fraction(own, a, d), 2.0, is_last_hit(primitive));
}

fn plane_fraction(i: u32, a: Real3, d: Real3) -> Real {
    return hit_plane(local_space(planes[i]), PLANE | i, a, d);
}

fn surface_plane(i: u32, x: Real3) -> Surface {
    let p = local_point(local_space(planes[i]), x);
    let g = planes[i].row_y.xyz;
    let steep = length(g);
    let n = g / steep;
    let uv = Real2(0.5 + 0.5 * p.x, 0.5 - 0.5 * p.z);
    return Surface(p.y / steep, 0.0, n, vec3f(n), vec2f(uv), planes[i].material, planes[i].object);
}
