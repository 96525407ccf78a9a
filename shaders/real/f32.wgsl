// Numbers of 32 bits: the default precision of paths. Functions whose built-in forms are inaccurate on some devices are implemented here
// (atan2 is wrong by 3e-6 in Mesa's software driver).

alias Real = f32;
alias Real2 = vec2<f32>;
alias Real3 = vec3<f32>;
alias Real4 = vec4<f32>;

// A relative difference of a few roundings.
const LAST_PART: Real = 2e-7;

// The relative difference up to which squared indices are equal: rounding must not make a surface out of a smooth medium.
const MATCHED: Real = 4e-6;

// The distance from a surface, relative to the distance from the origin, that rounding may give to a point on the surface.
const SURFACE_SLACK: Real = 1e-6;

// The number of steps of at least a quarter turn that is practically exact.
const ASYMPTOTE_STEPS: u32 = 32u;

// The number of steps of a whole turn around a center that is practically exact.
const ROUND_STEPS: u32 = 128u;

// Compilers may assume that there is no NaN in comparisons, but not in bits.
fn finite(a: Real3) -> bool {
    return all((bitcast<vec3u>(a) & vec3u(0x7f800000u)) != vec3u(0x7f800000u));
}

// Returns the argument bit by bit, opaque to compilers: the result of a step must not be simplified together with its use (x₁ − x₀ to h v),
// or passes that are divided differently would round differently; and sums in a given order must stay in it, which GPU compilers change.
fn opaque(a: Real) -> Real {
    return bitcast<f32>(bitcast<u32>(a) ^ frame.zero);
}

fn opaque3(a: Real3) -> Real3 {
    return bitcast<vec3f>(bitcast<vec3u>(a) ^ vec3u(frame.zero));
}

fn opaque4(a: Real4) -> Real4 {
    return bitcast<vec4f>(bitcast<vec4u>(a) ^ vec4u(frame.zero));
}

fn real_exp(a: Real) -> Real {
    return exp(a);
}

// Returns ln x for a normal x > 0 (the built-in form is wrong by 7e-5 near 1 in Mesa's software driver): x = 2^k m with m from √½ to √2,
// and ln m by the minimax polynomial of FreeBSD's logf (Sun's fdlibm, with the terms that f32 needs).
fn real_log(x: Real) -> Real {
    // The distance from the fraction of √2 to the next exponent carries every value above √2 over.
    let k = ((bitcast<i32>(x) + 0x4afb0d) >> 23u) - 127;
    // 2⁻ᵏ in two factors, because it may be too small or too large for one.
    let half = k / 2;
    let f = x * bitcast<f32>((127 - half) << 23u) * bitcast<f32>((127 - (k - half)) << 23u) - 1.0;
    let s = f / (2.0 + f);
    let z = s * s;
    let p = z * (0.66666662693 + z * (0.40000972152 + z * (0.28498786688 + z * 0.24279078841)));
    let square = 0.5 * f * f;
    let n = Real(k);
    return s * (square + p) + n * 9.0580006145e-6 - square + f + n * 6.9313812256e-1;
}

// Returns ln(a/b), accurate to its last digits if the two are close: then it is 2 artanh((a − b)/(a + b)).
fn log_ratio(a: Real, b: Real) -> Real {
    let s = (a - b) / (a + b);
    let z = s * s;
    let near = s * (2.0 + z * (0.66666667 + z * (0.4 + z * (0.28571429 + z * 0.22222222))));
    return select(real_log(a / b), near, abs(s) < 0.17);
}

// Infinity, and not a number. WGSL has no literals for them, so that they are computed with `frame.zero`, whose value compilers do not
// know.
fn infinite() -> Real {
    return bitcast<f32>(0x7f800000u ^ frame.zero);
}

fn not_a_number() -> Real {
    return bitcast<f32>(0x7fc00000u ^ frame.zero);
}

fn is_not_a_number(a: Real) -> bool {
    return (bitcast<u32>(a) & 0x7fffffffu) > 0x7f800000u;
}

// Returns the sine and cosine of a, for |a| up to 1e4 (built-in forms err by 4e-7 on GPUs, as much as the sine of a small angle): those of
// r = a − n π/2, exchanged and signed by n. π/2 is subtracted in three parts, the first of which has so few bits that its multiples are
// exact.
fn real_sin_cos(a: Real) -> Real2 {
    let n = floor(a * (2.0 / PI) + 0.5);
    let r = opaque(opaque(a - n * 1.5703125) - n * 4.837512969970703e-4) - n * 7.549789948768648e-8;
    // If angles are further apart than this, any result is as good.
    return quadrant_sin_cos(select(r, 0.0, abs(r) > 1.0), i32(n));
}

// Returns the sine and cosine of q quarter turns: whole ones are subtracted without rounding, so that the result for many turns is as
// accurate as q.
fn quarters_sin_cos(q: Real) -> Real2 {
    let n = floor(q + 0.5);
    return quadrant_sin_cos((q - n) * (0.5 * PI), i32(n));
}

// Returns the sine and cosine of r + k π/2, |r| ≤ π/4, by polynomials of Moshier's Cephes library (sinf, cosf).
fn quadrant_sin_cos(r: Real, k: i32) -> Real2 {
    let z = r * r;
    let sine = r + r * z * (-1.6666654611e-1 + z * (8.3321608736e-3 - z * 1.9515295891e-4));
    let cosine = 1.0 - z * (0.5 - z * (4.166664568298827e-2 + z * (-1.388731625493765e-3 + z * 2.443315711809948e-5)));
    let odd = (k & 1) != 0;
    let y = select(sine, cosine, odd);
    let x = select(cosine, sine, odd);
    return Real2(select(y, -y, (k & 2) != 0), select(x, -x, ((k + 1) & 2) != 0));
}

// Returns atan2 with an absolute error under 4e-7: atan on [0, tan π/8] by the minimax polynomial of Moshier's Cephes library (atanf),
// moved to the right octant.
fn arc_tangent(y: Real, x: Real) -> Real {
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
