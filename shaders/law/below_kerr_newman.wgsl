// Finds the rays that a camera inside the horizon can see: light that fell in after it. Light from below would stay near the inside of the
// horizon forever, and is dark. Followed into the past, light leaves through the horizon only if P = (r₊² + a²) E − a L is above 0 there.

fn end_below(p: Phase, ray: ptr<function, Ray>) {
    let d = p[0] - law.center;
    let momentum = law_momentum(p[0], p[1]);
    let a2 = dot(law.spin, law.spin);
    let r = law.mass + sqrt(max(law.mass * law.mass - a2 - law.charge_squared, 0.0));
    // Into the past L has the opposite sign.
    let outwards = (r * r + a2) * momentum.w + dot(law.spin, cross(d, momentum.xyz));
    if (*ray).status == ALIVE && outwards <= 0.0 && spheroid_of(d, law.spin).x < r {
        (*ray).status = CAPTURED;
    }
}
