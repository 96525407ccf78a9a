// Functions whose built-in forms are inaccurate on some devices (atan2 is wrong by 3e-6 on lavapipe).

const PI: f32 = 3.14159265358979;

// atan2 with an absolute error under 4e-7: atan on [0, tan π/8] by the minimax polynomial of Moshier's Cephes library
// (atanf), moved to the right octant.
fn arc_tangent(y: f32, x: f32) -> f32 {
    let big = max(abs(x), abs(y));
    let small = min(abs(x), abs(y));
    // atan(q) = π/4 + atan((q − 1)/(q + 1)) halves the interval, so that few terms are enough.
    let folded = small > 0.41421356 * big;
    let num = select(small, small - big, folded);
    let den = select(big, small + big, folded);
    let q = select(num / den, 0.0, den == 0.0);
    let s = q * q;
    let series = q + q * s * (-3.33329491539e-1 + s * (1.99777106478e-1 + s * (-1.38776856032e-1 + s * 8.05374449538e-2)));
    var angle = series + select(0.0, 0.25 * PI, folded);
    angle = select(angle, 0.5 * PI - angle, abs(y) > abs(x));
    angle = select(angle, PI - angle, x < 0.0);
    return select(angle, -angle, y < 0.0);
}
