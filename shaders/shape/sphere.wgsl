// Spheres (W04 §3.3, with the finite extent of a piece).

const SPHERE: u32 = 0x00000000u;

struct Ball {
    center: Real3,
    radius: Real,
}

@group(0) @binding(80) var<storage, read> spheres: array<Placed>;
@group(0) @binding(74) var<uniform> balls: array<Ball, SPHERE_COUNT>;

fn sphere_interval(center: Real3, radius: Real, a: Real3, d: Real3) -> Interval {
    return ball_interval(a - center, d, 1.0 / dot(d, d), radius * radius);
}

fn sphere_fraction(i: u32, a: Real3, d: Real3) -> Real {
    return first_end(sphere_interval(spheres[i].center, spheres[i].radius, a, d));
}

fn hit_sphere(a: Real3, b: Real3, best: Hit) -> Hit {
    var hit = best;
    for (var i = 0u; i < SPHERE_COUNT; i++) {
        work += 1u;
        let t = first_end(sphere_interval(balls[i].center, balls[i].radius, a, b - a));
        if t < hit.t {
            hit = Hit(t, SPHERE | i);
        }
    }
    return hit;
}

fn surface_sphere(i: u32, x: Real3) -> Surface {
    let d = x - spheres[i].center;
    let r = length(d);
    let uv = sphere_uv(own_vector(own_space(spheres[i]), d));
    let radius = spheres[i].radius;
    return Surface(r - radius, radius, d / r, vec3f(d / r), uv, spheres[i].material, spheres[i].object);
}
