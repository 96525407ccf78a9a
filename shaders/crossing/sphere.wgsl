// Crossing spheres: behind the opaque ones in their list.

struct SidedBall {
    center: Real3,
    radius: Real,
    bit: u32,
}

@group(0) @binding(66) var<uniform> sided_balls: array<SidedBall, SIDED_SPHERE_COUNT>;

fn ball_span(a: Real3, d: Real3, inverse_dd: Real, r2: Real) -> Real2 {
    let nearest = -dot(a, d) * inverse_dd;
    let miss = a + nearest * d;
    let inside2 = r2 - dot(miss, miss);
    let half = sqrt(max(inside2, 0.0) * inverse_dd);
    return select(no_span(), Real2(nearest - half, nearest + half), inside2 > 0.0);
}

fn cross_sphere(a: Real3, b: Real3, best: Hit) -> Hit {
    var hit = best;
    let d = b - a;
    let inverse_dd = 1.0 / dot(d, d);
    for (var i = 0u; i < SIDED_SPHERE_COUNT; i++) {
        work += 1u;
        let ball = sided_balls[i];
        let t = crossing(ball_span(a - ball.center, d, inverse_dd, ball.radius * ball.radius), ball.bit);
        if t < hit.t {
            hit = Hit(t, SPHERE | (SPHERE_COUNT + i));
        }
    }
    return hit;
}
