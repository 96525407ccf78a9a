// The motion of light in a custom metric. With U = (v, −1), g U′ = force + κ g U, and τ is the coordinate time, so that U′ has no time
// component: this condition determines κ. If the slice of constant time is not spacelike (γ not positive) or the signature is wrong (α² ≤
// 0), the result is not a number, and the ray fails.

// The metric g: components xx, yy, zz and yz, xz, xy of space; xt, yt, zt; and tt of time.
struct Metric {
    own: Real3,
    mixed: Real3,
    shift: Real3,
    clock: Real,
}

// The metric with its force, in space and in time.
struct MetricBend {
    metric: Metric,
    force: Real3,
    power: Real,
}

fn metric_lowered(m: Metric, a: Real3) -> Real3 {
    return m.own * a + m.mixed.zzy * a.yxx + Real3(m.mixed.y * a.z, m.mixed.x * a.z, m.mixed.x * a.y);
}

// Returns g(k, k).
fn metric_square(m: Metric, k: Real4) -> Real {
    return dot(k.xyz, metric_lowered(m, k.xyz) + (2.0 * k.w) * m.shift) + m.clock * k.w * k.w;
}

// The Cholesky factor of γ: the inverse of its diagonal, and the elements below it, yx, zx, zy.
struct Factor {
    inverse: Real3,
    below: Real3,
}

fn metric_factor(m: Metric) -> Factor {
    let x = inverseSqrt(m.own.x);
    let yx = m.mixed.z * x;
    let zx = m.mixed.y * x;
    let y = inverseSqrt(m.own.y - yx * yx);
    let zy = (m.mixed.x - yx * zx) * y;
    let z = inverseSqrt(m.own.z - zx * zx - zy * zy);
    return Factor(Real3(x, y, z), Real3(yx, zx, zy));
}

fn metric_raised(f: Factor, a: Real3) -> Real3 {
    let x = a.x * f.inverse.x;
    let y = (a.y - f.below.x * x) * f.inverse.y;
    let z = (a.z - f.below.y * x - f.below.z * y) * f.inverse.z;
    let c = z * f.inverse.z;
    let b = (y - f.below.z * c) * f.inverse.y;
    return Real3((x - f.below.x * b - f.below.y * c) * f.inverse.x, b, c);
}

// Returns dv/dτ, and d ln k/dτ, where kU is the momentum of light.
fn metric_stretch(bend: MetricBend, v: Real3) -> Real4 {
    let m = bend.metric;
    let factor = metric_factor(m);
    let force = metric_raised(factor, bend.force);
    let shift = metric_raised(factor, m.shift);
    let lapse2 = dot(m.shift, shift) - m.clock;
    let kappa = (dot(m.shift, force) - bend.power) / select(not_a_number(), lapse2, lapse2 > 0.0);
    return Real4(force + kappa * (v - shift), -kappa);
}

fn metric_pull(bend: MetricBend, v: Real3) -> Real3 {
    return metric_stretch(bend, v).xyz;
}

fn as_light(m: Metric, v: Real3) -> Real3 {
    return v / light_speed(-m.clock, dot(m.shift, v), dot(v, metric_lowered(m, v)));
}
