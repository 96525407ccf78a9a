// Crossing spheres: behind the opaque ones in their list.

struct SidedBall {
    center: Real3,
    radius: Real,
    bit: u32,
}

@group(0) @binding(66) var<uniform> sided_sphere_list: array<SidedBall, SIDED_SPHERE_COUNT>;

fn cross_sphere(own: SidedBall, a: Real3, d: Real3) -> Real {
    return crossing(ball_interval(a - own.center, d, 1.0 / dot(d, d), own.radius * own.radius), own.bit);
}
