// The separated equations of light around a black hole with spin a and charge Q: r and the angles evolve independently in the Mino
// parameter s, with ds = dλ/Σ and Σ = r² + a² cos²θ. With u = 1/r and a unit vector n of the angles, in axes that turn about the spin by
// ψ(s),
//
//     u″ = (a²E² − G) u + 3MK u² − 2(a²η + Q²K) u³,    n″ = a²E² n_z e_z − (G + 2a²E² n_z²) n,    ψ′ = a (E − W),
//
// where E, aL, G, K = G − 2aLE + a²E² and η = G − L² are constants of motion. There are no square roots and no signs of turning points, the
// axis needs no special case, and the horizon appears in W alone. Steps are as long as the angles allow, however far a ray goes.
//
// n is the l of Kerr–Schild coordinates: the position is r n + a e_z × n, turned by ψ. Momenta are scaled so that E² + (G + a²E²)/M² = 1,
// which also works inside an ergosphere.

struct Orbit {
    u: Real,
    // u′.
    w: Real,
    // ψ.
    angle: Real,
    // √(G − a²E²): far away u behaves like u of a straight line with this h.
    h: Real,
    n: Real3,
    // n′.
    t: Real3,
    // W = −l·(dx, dt), which drives ψ and τ.
    gap: Real,
    energy: Real,
    // E + (a²E − aL) u² is P u², with P of the radial equation.
    lift: Real,
    // The Carter constant K.
    carter: Real,
    total: Real,
    // a²E².
    twist: Real,
    // The factors of u² and u³ in u″.
    pull: Real2,
}

fn orbit_center() -> Real3 {
    return law.center;
}

// Returns the u up to which the pull is small compared with G u.
fn orbit_calm() -> Real {
    return 1.0 / (3.0 * law.mass);
}

// Returns axes of which the third is the spin axis.
fn spin_axes() -> mat3x3<Real> {
    let e = law.axis;
    let side = select(Real(-1.0), 1.0, e.z >= 0.0);
    let k = -1.0 / (side + e.z);
    let both = e.x * e.y * k;
    let first = Real3(1.0 + side * e.x * e.x * k, side * both, -side * e.x);
    return mat3x3<Real>(first, Real3(both, side + e.y * e.y * k, -e.y), e);
}

// Returns e_z × y.
fn across_spin(y: Real3) -> Real3 {
    return Real3(-y.y, y.x, 0.0);
}

// Returns Δ u², which is 0 at a horizon.
fn orbit_delta(u: Real) -> Real {
    return 1.0 - u * (2.0 * law.mass - (dot(law.spin, law.spin) + law.charge_squared) * u);
}

// Returns W = (P − r′)/Δ for inward motion and K/(P + r′), which is equal, for outward motion: neither becomes 0/0.
fn orbit_gap(o: Orbit, u: Real, w: Real) -> Real {
    let u2 = u * u;
    let p = o.energy + o.lift * u2;
    let inwards = w > 0.0;
    // A step may end inside the horizon, where it is captured.
    return select(o.carter * u2, p + w, inwards) / select(p - w, max(orbit_delta(u), 1e-6), inwards);
}

fn orbit_of(place: Real3, v: Real3) -> Orbit {
    let axes = spin_axes();
    let x = (place - law.center) * axes;
    let d = v * axes;
    let a2 = dot(law.spin, law.spin);
    let a = sqrt(a2);
    let spheroid = spheroid_of(x, Real3(0.0, 0.0, a));
    let r = spheroid.x;
    let sigma = 2.0 * spheroid.y;
    let outwards = Real3(r * x.xy, (r + a2 / r) * x.z);
    let own = 1.0 / (r * r + a2);
    let n = own * (outwards - a * across_spin(x));
    let f = (2.0 * law.mass * r - law.charge_squared) / sigma;
    let gap = 1.0 - dot(n, d);
    let energy = 1.0 - f * gap;
    let rising = dot(d, outwards);
    let y = sigma * d - (a * (energy - gap)) * across_spin(x) - rising * n;
    let t = Real3(own * (r * y.xy - a * across_spin(y).xy), y.z / r);
    let momentum = -a * dot(across_spin(x), d - (f * gap) * n);
    return orbit_kept(1.0 / r, -rising / (r * r), n, t, gap, energy, momentum);
}

// Returns the orbit for u, u′, n, n′, W, E and aL, with all constants, scaled.
fn orbit_kept(u: Real, w: Real, n: Real3, t: Real3, gap: Real, energy: Real, momentum: Real) -> Orbit {
    let a2 = dot(law.spin, law.spin);
    let twist = a2 * energy * energy;
    let turn = dot(t, t) + twist * (1.0 - n.z * n.z);
    let total = turn - twist;
    let carter = turn - 2.0 * momentum * energy;
    let eta = a2 * total - momentum * momentum;
    let k = inverseSqrt(energy * energy + turn / (law.mass * law.mass));
    let kk = k * k;
    var o: Orbit;
    o.u = u;
    o.w = k * w;
    o.angle = 0.0;
    o.h = k * sqrt(max(total - twist, 0.0));
    o.n = n;
    o.t = k * t;
    o.gap = k * gap;
    o.energy = k * energy;
    o.lift = k * (a2 * energy - momentum);
    o.carter = kk * carter;
    o.total = kk * total;
    o.twist = kk * twist;
    o.pull = kk * Real2(3.0 * law.mass * carter, -2.0 * (eta + law.charge_squared * carter));
    return o;
}

// Converts a vector from the turning axes to the scene's axes.
fn orbit_turned(o: Orbit, y: Real3) -> Real3 {
    let turn = real_sin_cos(o.angle);
    return spin_axes() * Real3(turn.y * y.xy + turn.x * across_spin(y).xy, y.z);
}

// Returns the position x and the velocity v.
fn orbit_point(o: Orbit) -> mat2x3<Real> {
    let a = length(law.spin);
    let r = 1.0 / o.u;
    let x = r * o.n + a * across_spin(o.n);
    let moved = r * o.t + a * across_spin(o.t) - (o.w * r * r) * o.n + (a * (o.energy - o.gap)) * across_spin(x);
    let v = moved / orbit_pace(o, o.u, o.n.z, o.gap);
    return mat2x3<Real>(law.center + orbit_turned(o, x), orbit_turned(o, v));
}

// Returns dτ/ds = ΣE + (2Mr − Q²) W.
fn orbit_pace(o: Orbit, u: Real, height: Real, gap: Real) -> Real {
    let r = 1.0 / u;
    let sigma = r * r + dot(law.spin, law.spin) * height * height;
    return sigma * o.energy + (2.0 * law.mass * r - law.charge_squared) * gap;
}

fn orbit_captured(o: Orbit) -> bool {
    return (o.w > 0.0) & (o.u * captured_within() > 1.0) & !orbit_turns(o);
}

// Returns the second derivatives of n and u.
fn orbit_rate(o: Orbit, y: Real4) -> Real4 {
    let turn = o.total + 2.0 * o.twist * y.z * y.z;
    let u = (o.twist - o.total) + y.w * (o.pull.x + y.w * o.pull.y);
    return Real4(-turn, -turn, o.twist - turn, u) * y;
}

// Returns the second derivatives of n and u at the orbit's own point.
fn orbit_bend(o: Orbit) -> Real4 {
    return orbit_rate(o, Real4(o.n, o.u));
}

// Takes a Nyström step of order 4; ψ follows by Simpson's rule.
fn orbit_step(o: Orbit, s: Real) -> Orbit {
    let y = Real4(o.n, o.u);
    let v = Real4(o.t, o.w);
    let a1 = orbit_rate(o, y);
    let a2 = orbit_rate(o, y + (0.5 * s) * (v + (0.25 * s) * a1));
    let a3 = orbit_rate(o, y + s * (v + (0.5 * s) * a2));
    let sixth = s * (1.0 / 6.0);
    let place = y + s * (v + sixth * (a1 + 2.0 * a2));
    let speed = v + sixth * (a1 + 4.0 * a2 + a3);
    var next = o;
    next.n = place.xyz;
    next.t = speed.xyz;
    next.u = place.w;
    next.w = speed.w;
    next.gap = orbit_gap(o, next.u, next.w);
    let middle = 0.5 * (o.u + next.u) + 0.125 * s * (o.w - next.w);
    let onward = o.w + (0.25 * sixth) * (5.0 * a1.w + 8.0 * a2.w - a3.w);
    let gaps = o.gap + 4.0 * orbit_gap(o, middle, onward) + next.gap;
    next.angle += length(law.spin) * (s * o.energy - sixth * gaps);
    return next;
}

// Returns the step by which n turns through eta at most, and u advances no further at its own rate, which is the greater one near the black
// hole; and by which u changes by three times that fraction of `size` or less.
fn orbit_stride(o: Orbit, eta: Real, size: Real) -> Real {
    let own = abs(o.twist - o.total + o.u * (2.0 * o.pull.x + 3.0 * o.pull.y * o.u));
    let turn = inverseSqrt(max(max(o.total + o.twist, own), 1e-30));
    return min(eta * turn, min(3.0 * eta, 0.5) * size / abs(o.w));
}

// Returns the orbit that comes in along the line through x with velocity v. There W = 2E, and in axes that turn by −aE n′ is E times the
// vector from the black hole to the line.
fn orbit_from_infinity(x: Real3, v: Real3) -> Orbit {
    let axes = spin_axes();
    let energy = length(v);
    let d = (v / energy) * axes;
    let y = (x - law.center) * axes;
    let off = y - dot(y, d) * d;
    let momentum = -length(law.spin) * energy * dot(across_spin(off), d);
    return orbit_kept(0.0, energy, -d, energy * off, 2.0 * energy, energy, momentum);
}

// Returns the direction of the orbit at infinity, where u = 0.
fn orbit_asymptote(o: Orbit) -> Real3 {
    return -o.w * orbit_turned(o, o.n);
}
