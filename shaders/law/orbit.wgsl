// The orbit equation around the only center of a law. A ray stays in a plane through the center. There u = 1/r obeys the Binet equation, in
// the parameter s with ds = dτ/r² instead of the angle φ = h s, so that radial rays, whose h = |x × v| is 0, need no special case:
//
//     w = du/ds = −ṙ,    dw/ds = P(u) − h² u,
//
// with P = −r² a_r of the law. A straight line is a harmonic oscillation in s: steps are as long as the angle allows, however far the ray
// goes, and one evaluation is a few scalar operations.

struct Orbit {
    u: Real,
    w: Real,
    // The angle φ from n.
    angle: Real,
    h: Real,
    // Unit vectors: from the center to the start of the orbit, and perpendicular to it in the direction of motion.
    n: Real3,
    t: Real3,
}

fn orbit_of(place: Real3, v: Real3) -> Orbit {
    let x = place - orbit_center();
    let r = length(x);
    let n = x / r;
    let radial = dot(n, v);
    let across = v - radial * n;
    let speed = length(across);
    // A radial ray never turns towards its t, so that any t will do.
    let t = across / max(speed, 1e-30);
    return Orbit(1.0 / r, -radial, 0.0, r * speed, n, t);
}

// Returns the position x and the velocity v.
fn orbit_point(o: Orbit) -> mat2x3<Real> {
    let turn = real_sin_cos(o.angle);
    let outward = turn.y * o.n + turn.x * o.t;
    let onward = turn.y * o.t - turn.x * o.n;
    return mat2x3<Real>(orbit_center() + outward / o.u, (o.h * o.u) * onward - o.w * outward);
}

fn orbit_rate(u: Real, hh: Real) -> Real {
    return orbit_pull(u, hh) - hh * u;
}

fn orbit_captured(o: Orbit) -> bool {
    return (o.w > 0.0) & (o.u * captured_within() > 1.0);
}

// Returns the change of u and w in a Nyström step of order 4.
fn orbit_change(o: Orbit, s: Real) -> Real2 {
    let hh = o.h * o.h;
    let a1 = orbit_rate(o.u, hh);
    let a2 = orbit_rate(o.u + (0.5 * s) * (o.w + (0.25 * s) * a1), hh);
    let a3 = orbit_rate(o.u + s * (o.w + (0.5 * s) * a2), hh);
    let sixth = s * (1.0 / 6.0);
    return Real2(s * (o.w + sixth * (a1 + 2.0 * a2)), sixth * (a1 + 4.0 * a2 + a3));
}

fn orbit_step(o: Orbit, s: Real) -> Orbit {
    let change = orbit_change(o, s);
    var next = o;
    next.u += change.x;
    next.w += change.y;
    next.angle += o.h * s;
    return next;
}

// Returns the step by which the orbit turns through eta at most, and u changes by three times that fraction of `size` or less: the smaller
// of eta/max(h, √(|dw/ds|/size)) and that fraction over |w|, written so that no division waits for another.
fn orbit_stride(o: Orbit, eta: Real, size: Real) -> Real {
    let hh = o.h * o.h;
    let turn = sqrt(size / max(hh * size, abs(orbit_rate(o.u, hh))));
    return min(eta * turn, min(3.0 * eta, 0.5) * size / abs(o.w));
}

// Returns the direction of the orbit at infinity, where u = 0.
fn orbit_asymptote(o: Orbit) -> Real3 {
    let turn = real_sin_cos(o.angle);
    return -o.w * (turn.y * o.n + turn.x * o.t);
}

// Returns the orbit that comes in along the line through x with velocity v.
fn orbit_from_infinity(x: Real3, v: Real3) -> Orbit {
    let speed = length(v);
    let d = v / speed;
    let y = x - orbit_center();
    let off = y - dot(y, d) * d;
    let b = length(off);
    return Orbit(0.0, speed, 0.0, b * speed, -d, off / max(b, 1e-30));
}
