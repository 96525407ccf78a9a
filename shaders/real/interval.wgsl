// Intervals, as their lowest and highest numbers: an operation encloses all values that it has for arguments in its intervals (Moore 1966).
// The result of an operation that is undefined or too large is unbounded. Rounding is not considered, because a few roundings do not matter.

const UNBOUNDED: Real = 1e30;

fn interval_all() -> Real2 {
    return Real2(-UNBOUNDED, UNBOUNDED);
}

fn interval_bounded(a: Real2) -> Real2 {
    return clamp(a, Real2(-UNBOUNDED), Real2(UNBOUNDED));
}

fn interval_sum(a: Real2, b: Real2) -> Real2 {
    return interval_bounded(a + b);
}

fn interval_difference(a: Real2, b: Real2) -> Real2 {
    return interval_bounded(a - b.yx);
}

fn interval_negative(a: Real2) -> Real2 {
    return -a.yx;
}

fn interval_product(a: Real2, b: Real2) -> Real2 {
    let p = a * b;
    let q = a * b.yx;
    return interval_bounded(Real2(min(min(p.x, p.y), min(q.x, q.y)), max(max(p.x, p.y), max(q.x, q.y))));
}

fn interval_quotient(a: Real2, b: Real2) -> Real2 {
    let has_zero = all(Real2(b.x, -b.y) <= Real2(0.0));
    let inverse = 1.0 / select(b.yx, Real2(1.0), has_zero);
    return select(interval_product(a, inverse), interval_all(), has_zero);
}

fn interval_abs(a: Real2) -> Real2 {
    return Real2(max(max(a.x, -a.y), 0.0), max(-a.x, a.y));
}

fn interval_square(a: Real2) -> Real2 {
    let b = interval_abs(a);
    return interval_bounded(b * b);
}

// Returns aᵏ, k ≥ 1, which increases: a must not be negative if k is even.
fn interval_power(a: Real2, k: u32) -> Real2 {
    var p = a;
    for (var i = 1u; i < k; i++) {
        p = interval_bounded(p * a);
    }
    return p;
}

// Returns the range of a function between -1 and 1 whose slope is 1 at most, from its value at the middle.
fn interval_wave(a: Real2, middle: Real) -> Real2 {
    let half = 0.5 * (a.y - a.x);
    return select(clamp(Real2(middle - half, middle + half), Real2(-1.0), Real2(1.0)), Real2(-1.0, 1.0), half > 1.0);
}

fn interval_sin(a: Real2) -> Real2 {
    return interval_wave(a, real_sin_cos(0.5 * (a.x + a.y)).x);
}

fn interval_cos(a: Real2) -> Real2 {
    return interval_wave(a, real_sin_cos(0.5 * (a.x + a.y)).y);
}

fn interval_sqrt(a: Real2) -> Real2 {
    return sqrt(max(a, Real2(0.0)));
}

fn interval_log(a: Real2) -> Real2 {
    return select(Real2(real_log(max(a.x, 1e-37)), real_log(max(a.y, 1e-37))), Real2(-UNBOUNDED), a <= Real2(0.0));
}

fn interval_cosh(a: Real2) -> Real2 {
    let b = interval_abs(a);
    return interval_bounded(Real2(formula_cosh(b.x), formula_cosh(b.y)));
}

// Returns c where a < b, else d.
fn interval_choice(a: Real2, b: Real2, c: Real2, d: Real2) -> Real2 {
    let both = Real2(min(c.x, d.x), max(c.y, d.y));
    return select(select(both, d, a.x >= b.y), c, a.y < b.x);
}
