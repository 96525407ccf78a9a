// Crossing spheres: behind the opaque ones in their list.

struct SidedBall {
    center: Real3,
    radius: Real,
    bit: u32,
}

@group(0) @binding(66) var<uniform> sided_balls: array<SidedBall, SIDED_SPHERE_COUNT>;

fn cross_sphere(a: Real3, b: Real3, best: Hit) -> Hit {
    var hit = best;
    let d = b - a;
    let inverse_dd = 1.0 / dot(d, d);
    for (var i = 0u; i < SIDED_SPHERE_COUNT; i++) {
        work += 1u;
        let ball = sided_balls[i];
        let t = crossing(ball_interval(a - ball.center, d, inverse_dd, ball.radius * ball.radius), ball.bit);
        if t < hit.t {
            hit = Hit(t, SPHERE | (SPHERE_COUNT + i));
        }
    }
    return hit;
}
