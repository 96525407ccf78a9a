// Circles: rays in the Maxwell fisheye n = n₀/(1 + r²/a²). Under stereographic projection of space to a sphere in four dimensions (x = a
// Y/(1 − W), |Y|² + W² = 1) a ray is a great circle, with constant speed in the optical path length:
//
//     (Y, W)(α) = (Y₀, W₀) cos α + (Y₁, W₁) sin α,    dα = 2 n ds/(n₀ a).
//
// So rays through the center, which are straight, need no special case. Steps are measured in α.

struct Circle {
    // The point on the sphere, and the unit tangent in the direction of motion.
    here: Real4,
    onward: Real4,
}

fn circle_of(p: Phase) -> Circle {
    let d = (p[0] - media[place].center) / media[place].a;
    let u = normalize(p[1]);
    let rr = dot(d, d);
    let f = 1.0 / (1.0 + rr);
    let here = Real4((2.0 * f) * d, (rr - 1.0) * f);
    // d(Y, W) along u, scaled to a unit vector: |d(Y, W)| = 2f |dx|/a.
    let du = dot(d, u);
    return Circle(here, Real4(u - (2.0 * f * du) * d, 2.0 * f * du));
}

fn circle_point(c: Circle, alpha: Real) -> Phase {
    let turn = real_sin_cos(alpha);
    let at = turn.y * c.here + turn.x * c.onward;
    let onward = turn.y * c.onward - turn.x * c.here;
    let f = 1.0 / (1.0 - at.w);
    let d = f * at.xyz;
    // dx/dα = a (Y′ + W′ d)/(1 − W); n = n₀ (1 − W)/2.
    let u = onward.xyz + onward.w * d;
    let x = media[place].center + media[place].a * d;
    return Phase(x, (0.5 * media[place].n0 * (1.0 - at.w)) * normalize(u));
}

fn retaken_step(p: Phase, alpha: Real) -> Phase {
    return circle_point(circle_of(p), alpha);
}

// Returns dτ/dα = (2a/n₀)/(1 − W)².
fn circle_pace(w: Real) -> Real {
    return 2.0 * media[place].a / (media[place].n0 * (1.0 - w) * (1.0 - w));
}

// Returns τ by the three-point Gauss rule on quarters of the step.
fn circle_tau(p: Phase, alpha: Real) -> Real {
    let c = circle_of(p);
    var sum: Real = 0.0;
    for (var i = 0u; i < 4u; i++) {
        for (var k = 0u; k < 3u; k++) {
            let node = 0.5 + 0.3872983346207417 * (Real(k) - 1.0);
            let turn = real_sin_cos(alpha * 0.25 * (Real(i) + node));
            let weight = select(Real(5.0 / 72.0), Real(8.0 / 72.0), k == 1u);
            sum += weight * circle_pace(turn.y * c.here.w + turn.x * c.onward.w);
        }
    }
    return alpha * sum;
}

fn own_size(ray: Ray, next: Ray) -> Real {
    return stride(ray.phase);
}

fn own_pace(p: Phase) -> Real {
    let n = medium_index(p[0]);
    return 0.5 * media[place].n0 * media[place].a / (n * n);
}

fn own_measure(p: Phase, tau: Real) -> Real {
    return tau / own_pace(p);
}

fn own_tau(p: Phase, end: Phase, alpha: Real) -> Real {
    return circle_tau(p, alpha);
}

fn own_fraction(p: Phase, end: Phase, t: Real) -> Real {
    return t;
}

fn accepted_step(ray: Ray) -> Ray {
    let alpha = stride(ray.phase);
    let passed = circle_tau(ray.phase, alpha);
    return after_step(ray, retaken_step(ray.phase, alpha), passed);
}

// Returns one step to where W = W₀ cos α + W₁ sin α passes, outwards, its value on the surface of the sphere; or steps that a cubic arc can
// follow, short where the projection is stretched.
fn stride(p: Phase) -> Real {
    if !IS_EMPTY {
        let d = (p[0] - media[place].center) / media[place].a;
        return 0.3 / (1.0 + 0.3 * sqrt(dot(d, d)));
    }
    let c = circle_of(p);
    let q = here().radius / media[place].a;
    let edge = (q * q - 1.0) / (q * q + 1.0);
    let w0 = c.here.w;
    let w1 = c.onward.w;
    let side = sqrt(max(w0 * w0 + w1 * w1 - edge * edge, 0.0));
    let angle = arc_tangent(w1, w0) - arc_tangent(side, edge);
    return next_turn(angle, w1 >= 0.0 && w0 >= edge - LAST_PART);
}
