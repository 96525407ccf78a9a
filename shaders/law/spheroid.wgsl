// The oblate spheroids of constant Boyer–Lindquist r around a black hole of spin a.

// Returns, at x relative to the black hole: r, d = ½(r² + a² cos²θ), and a·x = r a cos θ.
fn spheroid_of(x: Real3, a: Real3) -> Real3 {
    let k = 0.5 * (dot(x, x) - dot(a, a));
    let along = dot(a, x);
    let d = sqrt(k * k + along * along);
    // r² = k + d, without cancellation near the ring.
    let r2 = select(along * along / (d - k), k + d, k > 0.0);
    return Real3(sqrt(max(r2, 1e-30)), d, along);
}
