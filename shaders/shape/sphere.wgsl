// Intersects spheres (W04 §3.3, with the finite extent of a piece).

struct Ball {
    center: Real3,
    radius: Real,
}

var<storage, read> spheres: array<Placed>;
var<uniform> sphere_list: array<Ball, SPHERE_COUNT>;

fn sphere_interval(center: Real3, radius: Real, a: Real3, d: Real3) -> Interval {
    return ball_interval(a - center, d, 1.0 / dot(d, d), radius * radius);
}

fn hit_sphere(own: Ball, primitive: u32, a: Real3, d: Real3) -> Real {
    return first_end(sphere_interval(own.center, own.radius, a, d));
}

fn sphere_fraction(i: u32, a: Real3, d: Real3) -> Real {
    return hit_sphere(Ball(spheres[i].center, spheres[i].radius), SPHERE | i, a, d);
}

fn surface_sphere(i: u32, x: Real3) -> Surface {
    let d = x - spheres[i].center;
    let r = length(d);
    let uv = sphere_uv(local_vector(local_space(spheres[i]), d));
    let radius = spheres[i].radius;
    return Surface(r - radius, radius, d / r, vec3f(d / r), uv, spheres[i].material, spheres[i].object);
}

// Spheres that rays cross: after the opaque ones in their list.

struct SidedBall {
    center: Real3,
    radius: Real,
    bit: u32,
}

var<uniform> sided_sphere_list: array<SidedBall, SIDED_SPHERE_COUNT>;

fn cross_sphere(own: SidedBall, a: Real3, d: Real3) -> Real {
    return crossing(ball_interval(a - own.center, d, 1.0 / dot(d, d), own.radius * own.radius), own.bit);
}
