// Flat rectangles: the square |x|, |z| ≤ 1 of y = 0 in their own space.

const PLANE: u32 = 0x30000000u;

@group(0) @binding(83) var<storage, read> planes: array<Placed>;
@group(0) @binding(77) var<uniform> plane_spaces: array<OwnSpace, PLANE_COUNT>;

fn square_fraction(space: OwnSpace, a: Real3, v: Real3) -> Real {
    let p = own_point(space, a);
    let d = own_vector(space, v);
    let t = -p.y / d.y;
    let q = abs(p.xz + t * d.xz);
    return select(2.0, t, d.y != 0.0 && t >= -overlap() && t <= 1.0 + OVERLAP && max(q.x, q.y) <= 1.0);
}

fn plane_fraction(i: u32, a: Real3, d: Real3) -> Real {
    return select(square_fraction(own_space(planes[i]), a, d), 2.0, just_left(PLANE | i));
}

fn hit_plane(a: Real3, b: Real3, best: Hit) -> Hit {
    var hit = best;
    for (var i = 0u; i < PLANE_COUNT; i++) {
        work += 1u;
        let t = square_fraction(plane_spaces[i], a, b - a);
        if t < hit.t && !just_left(PLANE | i) {
            hit = Hit(t, PLANE | i);
        }
    }
    return hit;
}

fn surface_plane(i: u32, x: Real3) -> Surface {
    let p = own_point(own_space(planes[i]), x);
    let g = planes[i].row_y.xyz;
    let steep = length(g);
    let n = g / steep;
    let uv = Real2(0.5 + 0.5 * p.x, 0.5 - 0.5 * p.z);
    return Surface(p.y / steep, 0.0, n, vec3f(n), vec2f(uv), planes[i].material, planes[i].object);
}
