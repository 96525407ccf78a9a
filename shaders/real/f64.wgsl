// Numbers of 64 bits, for reference solutions.
//
// The elementary functions in f64 use arithmetic alone: WGSL has none for f64, and those that drivers accept are missing or have the
// accuracy of f32. The bits of an f64 are not accessible either: powers of two come from f32. There are no branches, since neighboring
// invocations would run both sides anyway. The polynomials are minimax (Remez, in 60 digits, weighted to the relative error of the result)
// and add less than 2e-17.

alias Real = f64;
alias Real2 = vec2<f64>;
alias Real3 = vec3<f64>;
alias Real4 = vec4<f64>;

// A relative difference of a few roundings.
const LAST_PART: Real = 4e-16;

// The relative difference up to which squared indices are equal: rounding must not make a surface out of a smooth medium.
const MATCHED: Real = 1e-13;

// The distance from a surface, relative to the distance from the origin, that rounding may give to a point on the surface.
const SURFACE_SLACK: Real = 1e-14;

// The number of steps of at least a quarter turn that is practically exact.
const ASYMPTOTE_STEPS: u32 = 1024u;

// The number of steps of a whole turn around a center that is practically exact.
const ROUND_STEPS: u32 = 1024u;

// Values beyond the range of f32 are larger than every scene.
fn finite(a: Real3) -> bool {
    return all((bitcast<vec3u>(vec3f(a)) & vec3u(0x7f800000u)) != vec3u(0x7f800000u));
}

// Returns the argument unchanged, opaque to compilers: the result of a step must not be simplified together with its use (x₁ − x₀ to h v),
// or passes that are divided differently would round differently; and sums in a given order must stay in it, which GPU compilers change.
// WGSL has no bit operations on f64: a select blocks simplification too.
fn opaque(a: Real) -> Real {
    return select(a, 0.0, frame.zero != 0u);
}

fn opaque3(a: Real3) -> Real3 {
    return select(a, Real3(0.0), frame.zero != 0u);
}

fn opaque4(a: Real4) -> Real4 {
    return select(a, Real4(0.0), frame.zero != 0u);
}

// Infinity, and not a number. WGSL has no literals for them, so that they are computed with `frame.zero`, whose value compilers do not
// know.
fn infinite() -> Real {
    return Real(bitcast<f32>(0x7f800000u ^ frame.zero));
}

fn not_a_number() -> Real {
    return Real(bitcast<f32>(0x7fc00000u ^ frame.zero));
}

fn is_not_a_number(a: Real) -> bool {
    return (bitcast<u32>(f32(a)) & 0x7fffffffu) > 0x7f800000u;
}

const ONE: Real = 1.0;

// ln 2 and π/2 in two parts, the first with so few bits that its multiples are exact.
const LOG2_E: Real = 1.4426950408889634;
const LN_2_HIGH: Real = 0.6931471803691238;
const LN_2_LOW: Real = 1.9082149292705877e-10;
const QUARTERS_PER_RADIAN: Real = 0.6366197723675814;
const QUARTER_TURN_HIGH: Real = 1.5707963267341256;
const QUARTER_TURN_LOW: Real = 6.077100506506192e-11;
const EIGHTH_TURN: Real = 0.7853981633974483;

const TWO_TO_720: Real = 5.515652263101987e216;
const TWO_TO_MINUS_720: Real = 1.8130221999122236e-217;
const TWO_TO_240: Real = 1.7668470647783843e72;
const TWO_TO_MINUS_240: Real = 5.659799424266695e-73;

// Returns 2^n for n from −126 to 127: the bits of an f32 without a fraction.
fn power_of_two(n: i32) -> Real {
    return Real(bitcast<f32>((n + 127) << 23u));
}

// Returns e^x = 2^n e^r with |r| ≤ ln 2 / 2. It underflows to 0 and overflows to infinity.
fn real_exp(x: Real) -> Real {
    // Beyond these bounds the result is 0 or infinite anyway, and they keep n small.
    let bounded = clamp(x, -750.0, 720.0);
    let n = floor(bounded * LOG2_E + 0.5);
    let r = opaque(bounded - n * LN_2_HIGH) - n * LN_2_LOW;
    // (e^r − 1 − r) / r²
    var p: Real = 2.500001729189504e-8;
    p = p * r + 2.763030629483995e-7;
    p = p * r + 2.7557586808315326e-6;
    p = p * r + 2.4801492949514462e-5;
    p = p * r + 1.9841269505769377e-4;
    p = p * r + 1.388888894376007e-3;
    p = p * r + 8.333333333494978e-3;
    p = p * r + 4.1666666666529725e-2;
    p = p * r + 0.1666666666666641;
    p = p * r + 0.5000000000000011;
    // 2^n exceeds the range of power_of_two, and may exceed f64 where e^x does not: hence three factors, n = 8h + 8h + (n mod 16).
    let k = i32(n);
    let h1 = power_of_two(k >> 4u);
    let h2 = h1 * h1;
    let h4 = h2 * h2;
    let h8 = h4 * h4;
    return opaque((1.0 + (r + r * r * p)) * power_of_two(k & 15) * h8) * h8;
}

// Returns (2 artanh s − 2s)/s³ for z = s², for |s| up to 0.172.
fn artanh_tail(z: Real) -> Real {
    var p: Real = 0.14797031938946162;
    p = p * z + 0.15313951700232742;
    p = p * z + 0.18183567810324863;
    p = p * z + 0.2222219851378319;
    p = p * z + 0.28571428742888333;
    p = p * z + 0.399999999994128;
    p = p * z + 0.6666666666666735;
    return p;
}

// Returns ln x = n ln 2 + ln m for x > 0, with m from √½ to √2. (At 0 about −755, which real_exp treats like −∞.)
fn real_log(x: Real) -> Real {
    // Two steps of ±720 and ±240 bring every exponent within the range of f32: the first beyond 2^±360, the second beyond 2^±120.
    let far = select(select(0, -720, x < 4.257959840008151e-109), 720, x > 2.3485425827738332e108);
    let nearer = x * select(select(ONE, TWO_TO_720, far < 0), TWO_TO_MINUS_720, far > 0);
    let off = select(select(0, -240, nearer < 7.52316384526264e-37), 240, nearer > 1.329227995784916e36);
    let near = nearer * select(select(ONE, TWO_TO_240, off < 0), TWO_TO_MINUS_240, off > 0);
    // The distance from the fraction of √2 to the next exponent carries every value above √2 over.
    let k = ((bitcast<i32>(f32(near)) + 0x4afb0d) >> 23u) - 127;
    let f = near * power_of_two(-k) - 1.0;
    // With s = f / (2 + f), ln m is 2 artanh s = f − (f²/2 − s (f²/2 + s² p)), which keeps f, and so ln x near 1, exact.
    let s = f / (2.0 + f);
    let z = s * s;
    let p = artanh_tail(z);
    let half = 0.5 * f * f;
    let n = Real(far + off + k);
    return n * LN_2_HIGH - opaque((half - (s * (half + z * p) + n * LN_2_LOW)) - f);
}

// Returns ln(a/b), accurate to its last digits if the two are close.
fn log_ratio(a: Real, b: Real) -> Real {
    let s = (a - b) / (a + b);
    return select(real_log(a / b), s * (2.0 + s * s * artanh_tail(s * s)), abs(s) < 0.17);
}

// Returns the sine and cosine of a, for |a| up to 1e6: those of r = a − n π/2, exchanged and signed by n.
fn real_sin_cos(a: Real) -> Real2 {
    let n = floor(a * QUARTERS_PER_RADIAN + 0.5);
    return quadrant_sin_cos(opaque(a - n * QUARTER_TURN_HIGH) - n * QUARTER_TURN_LOW, i32(n));
}

// Returns the sine and cosine of q quarter turns: whole ones are subtracted without rounding, so that the result for many turns is as
// accurate as q.
fn quarters_sin_cos(q: Real) -> Real2 {
    let n = floor(q + 0.5);
    return quadrant_sin_cos((q - n) * (2.0 * EIGHTH_TURN), i32(n));
}

// Returns the sine and cosine of r + k π/2, |r| ≤ π/4.
fn quadrant_sin_cos(r: Real, k: i32) -> Real2 {
    let z = r * r;
    // (sin r − r) / r³
    var p: Real = 1.5896067488478526e-10;
    p = p * z - 2.505074503739324e-8;
    p = p * z + 2.7557313604523236e-6;
    p = p * z - 1.9841269829542596e-4;
    p = p * z + 8.333333333322063e-3;
    p = p * z - 0.1666666666666663;
    // (cos r − 1 + r²/2) / r⁴
    var q: Real = -1.1358423522875494e-11;
    q = q * z + 2.0875698708674652e-9;
    q = q * z - 2.7557314163977853e-7;
    q = q * z + 2.480158728880003e-5;
    q = q * z - 1.3888888888872975e-3;
    q = q * z + 4.1666666666666595e-2;
    let sine = r + r * z * p;
    let cosine = 1.0 - z * (0.5 - z * q);
    let odd = (k & 1) != 0;
    let y = select(sine, cosine, odd);
    let x = select(cosine, sine, odd);
    return Real2(select(y, -y, (k & 2) != 0), select(x, -x, ((k + 1) & 2) != 0));
}

// Returns atan2, 0 at (0, 0): atan on [−tan π/8, tan π/8], moved to the right octant by a single sum, which is rounded once.
fn arc_tangent(y: Real, x: Real) -> Real {
    let big = max(abs(x), abs(y));
    let small = min(abs(x), abs(y));
    // atan(t) = π/4 + atan((t − 1) / (t + 1)) halves the interval.
    let folded = small > 0.41421356237309503 * big;
    let above = select(small, small - big, folded);
    let below = select(big, small + big, folded);
    // The smallest normal number replaces 0.
    let t = above / max(below, 2.2250738585072014e-308);
    let z = t * t;
    // (atan t − t) / t³
    var p: Real = -0.017897562532915967;
    p = p * z + 0.038055441181253265;
    p = p * z - 0.05038932154752239;
    p = p * z + 0.05847803229657372;
    p = p * z - 0.06663091689813028;
    p = p * z + 0.07692059074336197;
    p = p * z - 0.09090897690200365;
    p = p * z + 0.11111110780978423;
    p = p * z - 0.1428571428014398;
    p = p * z + 0.19999999999953033;
    p = p * z - 0.3333333333333319;
    let rest = t + t * z * p;
    let steep = abs(y) > abs(x);
    let left = x < 0.0;
    let first = select(0, 1, folded);
    let upper = select(first, 2 - first, steep);
    let eighths = Real(select(upper, 4 - upper, left));
    let angle = eighths * EIGHTH_TURN + select(rest, -rest, steep != left);
    return select(angle, -angle, y < 0.0);
}
