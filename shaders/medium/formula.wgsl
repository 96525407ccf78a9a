// The functions of formulas that the user wrote. Outside the domain of a function the result is not a number, so that the ray fails: the
// built-in functions may return anything there, and min and max may drop values that are not numbers.

// The largest angle that f32 resolves well enough.
const LARGEST_ANGLE: Real = 1e6;

fn formula_sqrt(a: Real) -> Real {
    return select(sqrt(max(a, 0.0)), not_a_number(), a < 0.0);
}

fn formula_log(a: Real) -> Real {
    // The smallest normal number replaces values that are flushed to 0.
    let safe = max(a, 1.1754944e-38);
    return select(select(real_log(safe), -infinite(), a == 0.0), not_a_number(), !(a >= 0.0));
}

fn formula_sin_cos(a: Real) -> Real2 {
    return select(real_sin_cos(a), Real2(not_a_number()), !(abs(a) <= LARGEST_ANGLE));
}

// (eᵃ − e⁻ᵃ)/2, near 0 by its series, where the difference would lose all digits.
fn formula_sinh(a: Real) -> Real {
    let s = a * a;
    let series = a * (1.0 + s / 6.0 * (1.0 + s / 20.0 * (1.0 + s / 42.0 * (1.0 + s / 72.0 * (1.0 + s / 110.0)))));
    return select(0.5 * (real_exp(a) - real_exp(-a)), series, abs(a) < 0.3);
}

fn formula_cosh(a: Real) -> Real {
    return 0.5 * (real_exp(a) + real_exp(-a));
}

// By e^(−2|a|), which does not overflow.
fn formula_tanh(a: Real) -> Real {
    let t = real_exp(-2.0 * abs(a));
    return formula_sign(a) * (1.0 - t) / (1.0 + t);
}

// Returns the sign of a, and preserves values that are not numbers.
fn formula_sign(a: Real) -> Real {
    let sign = select(select(Real(0.0), Real(1.0), a > 0.0), Real(-1.0), a < 0.0);
    return select(sign, a, is_not_a_number(a));
}

fn formula_min(a: Real, b: Real) -> Real {
    return select(select(b, a, a < b), not_a_number(), is_not_a_number(a) || is_not_a_number(b));
}

fn formula_max(a: Real, b: Real) -> Real {
    return select(select(b, a, a > b), not_a_number(), is_not_a_number(a) || is_not_a_number(b));
}
