// Numbers of 32 bits: what a path is followed in, unless the scene asks for more. Functions whose built-in forms are inaccurate
// on some devices are written out (atan2 is wrong by 3e-6 in Mesa's on a processor).

alias Real = f32;
alias Real2 = vec2<f32>;
alias Real3 = vec3<f32>;
alias Real4 = vec4<f32>;

// A part of a whole that is no more than a few roundings.
const LAST_PART: Real = 2e-7;

// Squared indices that agree to this part are the same: rounding must not make a surface out of a smooth place.
const MATCHED: Real = 4e-6;

// How far from a surface, in parts of its distance from the origin, a point may lie by rounding that is on it.
const SURFACE_SLACK: Real = 1e-6;

// Steps of a quarter turn and more that are as good as exact.
const ASYMPTOTE_STEPS: u32 = 32u;

// Steps of a whole turn about a centre that are as good as exact.
const ROUND_STEPS: u32 = 128u;

// Comparisons with NaN may be assumed away by a compiler; bits may not.
fn finite(a: Real3) -> bool {
    return all((bitcast<vec3u>(a) & vec3u(0x7f800000u)) != vec3u(0x7f800000u));
}

// The same bits, behind which no compiler sees: a step's result must not be simplified together with what uses it (x₁ − x₀
// to h v), or passes that are cut differently would round differently; and sums in a certain order must stay in it, which compilers
// of GPUs change.
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

// ln x for a normal x > 0 (the built-in form is wrong by 7e-5 near 1 in Mesa's on a processor): x = 2^k m with m from √½ to √2, and ln m by the
// minimax polynomial of FreeBSD's logf (Sun's fdlibm, with the terms that f32 needs).
fn real_log(x: Real) -> Real {
    // The distance from √2's fraction to the next exponent's carries everything above √2 over.
    let k = ((bitcast<i32>(x) + 0x4afb0d) >> 23u) - 127;
    // 2⁻ᵏ in two factors, for it may be too small or too large for one.
    let half = k / 2;
    let f = x * bitcast<f32>((127 - half) << 23u) * bitcast<f32>((127 - (k - half)) << 23u) - 1.0;
    let s = f / (2.0 + f);
    let z = s * s;
    let p = z * (0.66666662693 + z * (0.40000972152 + z * (0.28498786688 + z * 0.24279078841)));
    let square = 0.5 * f * f;
    let n = Real(k);
    return s * (square + p) + n * 9.0580006145e-6 - square + f + n * 6.9313812256e-1;
}

// ln(a/b), good to its last digits where the two are close: there it is 2 artanh((a − b)/(a + b)).
fn log_ratio(a: Real, b: Real) -> Real {
    let s = (a - b) / (a + b);
    let z = s * s;
    let near = s * (2.0 + z * (0.66666667 + z * (0.4 + z * (0.28571429 + z * 0.22222222))));
    return select(real_log(a / b), near, abs(s) < 0.17);
}

// What no calculation goes on from, and what stands for no value: no compiler knows them, for none could be written.
fn infinite() -> Real {
    return bitcast<f32>(0x7f800000u ^ frame.zero);
}

fn not_a_number() -> Real {
    return bitcast<f32>(0x7fc00000u ^ frame.zero);
}

fn is_not_a_number(a: Real) -> bool {
    return (bitcast<u32>(a) & 0x7fffffffu) > 0x7f800000u;
}

// Sine and cosine, for |a| up to 1e4 (built-in forms err by 4e-7 on GPUs, which is all of a small angle's sine): those of
// r = a − n π/2, exchanged and signed by n. π/2 comes off in three parts, of which the first has so few bits that its multiples are
// exact.
fn real_sin_cos(a: Real) -> Real2 {
    let n = floor(a * (2.0 / PI) + 0.5);
    let r = opaque(opaque(a - n * 1.5703125) - n * 4.837512969970703e-4) - n * 7.549789948768648e-8;
    // Where angles are further apart than this, one is as good as another.
    return quadrant_sin_cos(select(r, 0.0, abs(r) > 1.0), i32(n));
}

// Sine and cosine of q quarter turns: whole ones come off without rounding, so that an angle of many turns is as good as its q.
fn quarters_sin_cos(q: Real) -> Real2 {
    let n = floor(q + 0.5);
    return quadrant_sin_cos((q - n) * (0.5 * PI), i32(n));
}

// Sine and cosine of r + k π/2, |r| ≤ π/4. Polynomials of Moshier's Cephes library (sinf, cosf).
fn quadrant_sin_cos(r: Real, k: i32) -> Real2 {
    let z = r * r;
    let sine = r + r * z * (-1.6666654611e-1 + z * (8.3321608736e-3 - z * 1.9515295891e-4));
    let cosine = 1.0 - z * (0.5 - z * (4.166664568298827e-2 + z * (-1.388731625493765e-3 + z * 2.443315711809948e-5)));
    let odd = (k & 1) != 0;
    let y = select(sine, cosine, odd);
    let x = select(cosine, sine, odd);
    return Real2(select(y, -y, (k & 2) != 0), select(x, -x, ((k + 1) & 2) != 0));
}

// atan2 with an absolute error under 4e-7: atan on [0, tan π/8] by the minimax polynomial of Moshier's Cephes library
// (atanf), moved to the right octant.
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
