// Tori about y: what is no farther than `tube` from the circle of radius R = 1 − tube in y = 0 of their own space, all in the unit ball.
//
// A line is measured from its point nearest to the middle: p(s) = m + s u, |u| = 1, m · u = 0. Then f(s) = (|p|² + R² − tube²)² −
// 4 R² (x² + z²), which is below 0 inside, has no cube, and f′ = 4 (s³ + P s + Q). f is monotone between the roots of that, so that the
// first stretch at whose end the side has changed holds the first crossing, and no other. The roots are needed roughly only; sides and the
// crossing are found from the distance itself, which loses no digits near the surface.

const TORUS: u32 = 0x70000000u;

// A squared radius: whatever rounding does, what is on this ball is outside.
const TORUS_BALL: Real = 1.1;

// What is nearer to the surface than this, in own units, may be on it but for rounding.
const TORUS_ON: Real = 1e-4;

// Every other step halves a stretch that is no longer than 2.1; Newton's steps between them do the rest.
const TORUS_STEPS: u32 = 40u;

struct TorusSpace {
    row_x: Real4,
    row_y: Real4,
    row_z: Real4,
    // The tube's radius, in own units.
    tube: Real,
}

var<storage, read> tori: array<Placed>;
var<uniform> torus_list: array<TorusSpace, TORUS_COUNT>;

// From the circle inside the tube: away from the axis, and up.
fn from_ring(p: Real3, tube: Real) -> Real2 {
    return Real2(length(p.xz) - (1.0 - tube), p.y);
}

fn torus_distance(p: Real3, tube: Real) -> Real {
    return length(from_ring(p, tube)) - tube;
}

// The gradient of that distance, a unit vector.
fn torus_gradient(p: Real3, tube: Real) -> Real3 {
    let e = normalize(from_ring(p, tube));
    let away = e.x * normalize(p.xz);
    return Real3(away.x, e.y, away.y);
}

// The roots of s³ + p s + q, in ascending order; if there is one, three times that.
fn torus_turns(p: Real, q: Real) -> Real3 {
    let third = p / 3.0;
    let half = 0.5 * q;
    let square = half * half + third * third * third;
    if square >= 0.0 {
        let cube = max(abs(half) + sqrt(square), 1e-30);
        let a = real_exp(real_log(cube) / 3.0);
        return Real3(select(Real(1.0), -1.0, half > 0.0) * (a - third / a));
    }
    let angle = real_sin_cos(arc_tangent(sqrt(-square), -half) / 3.0);
    let size = 2.0 * sqrt(-third);
    let most = size * angle.y;
    let least = -0.5 * most - 0.8660254037844386 * size * angle.x;
    return Real3(least, -most - least, most);
}

// leaves: the segment begins on it. Where its piece does, wherever rounding has put that, the side is the one that it goes to.
fn tube_fraction(own: TorusSpace, a: Real3, d: Real3, leaves: bool) -> Real {
    let space = OwnSpace(own.row_x, own.row_y, own.row_z);
    let p = own_point(space, a);
    let v = own_vector(space, d);
    let speed = length(v);
    let u = v / speed;
    let nearest = -dot(p, u);
    let m = p + nearest * u;
    let mm = dot(m, m);
    let reach = sqrt(max(TORUS_BALL - mm, 0.0));
    let first = max(-overlap() * speed - nearest, -reach);
    let last = min((1.0 + OVERLAP) * speed - nearest, reach);
    // Written so that a piece without a length meets nothing.
    if !(mm < TORUS_BALL && first < last) {
        return 2.0;
    }
    let ring = 1.0 - own.tube;
    let rr = ring * ring;
    let roots = torus_turns(mm + rr * (1.0 - 2.0 * dot(u.xz, u.xz)) - own.tube * own.tube, -2.0 * rr * dot(m.xz, u.xz));
    let turns = Real4(roots, last);
    let begin = clamp(-nearest, first, last);
    let on = leaves && abs(torus_distance(m + begin * u, own.tube)) < TORUS_ON;
    let goes_in = dot(torus_gradient(m + begin * u, own.tube), u) < 0.0;
    let inside = select(torus_distance(m + first * u, own.tube) < 0.0, goes_in, on);
    // Before the beginning of what leaves it lies its other side.
    var hi = select(first, begin, on);
    var lo = hi;
    var found = false;
    for (var i = 0u; i < 4u; i++) {
        lo = select(hi, lo, found);
        hi = select(clamp(turns[i], lo, last), hi, found);
        found = found || (hi > lo && (torus_distance(m + hi * u, own.tube) < 0.0) != inside);
    }
    if !found {
        return 2.0;
    }
    var s = 0.5 * (lo + hi);
    for (var i = 0u; i < TORUS_STEPS; i++) {
        let x = m + s * u;
        let gap = torus_distance(x, own.tube);
        let before = (gap < 0.0) == inside;
        lo = select(lo, s, before);
        hi = select(s, hi, before);
        let newton = s - gap / dot(torus_gradient(x, own.tube), u);
        let next = select(0.5 * (lo + hi), newton, (i & 1u) == 0u && newton >= lo && newton <= hi);
        if next == s {
            break;
        }
        s = next;
    }
    return (s + nearest) / speed;
}

fn hit_torus(own: TorusSpace, primitive: u32, a: Real3, d: Real3) -> Real {
    return tube_fraction(own, a, d, is_last_hit(primitive));
}

fn torus_fraction(i: u32, a: Real3, d: Real3) -> Real {
    return hit_torus(TorusSpace(tori[i].row_x, tori[i].row_y, tori[i].row_z, tori[i].radius), TORUS | i, a, d);
}

fn surface_torus(i: u32, x: Real3) -> Surface {
    let space = own_space(tori[i]);
    let tube = tori[i].radius;
    let p = own_point(space, x);
    let g = scene_gradient(space, torus_gradient(p, tube));
    let steep = length(g);
    let n = g / steep;
    let e = from_ring(p, tube);
    let v = 0.5 + arc_tangent(e.y, e.x) / (2.0 * PI);
    let gap = (length(e) - tube) / steep;
    return Surface(gap, 1.0 / steep, n, vec3f(n), vec2f(turn_round(p), f32(v)), tori[i].material, tori[i].object);
}
