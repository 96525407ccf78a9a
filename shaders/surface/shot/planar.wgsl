// Finds paths from a light to a position around the only center of a law. They stay in the plane of the light, the position and the center,
// so that the only unknown is the angle at which the path leaves the light, from the line to the center. The orbit is followed to the angle
// of the position, on either side; at a path, the difference of its distance from the center there and the distance of the position changes
// its sign. All paths of less than one turn are found.

// The number of angles tested, which are denser near the center, where images of distant objects are; of bisections between two of them,
// with orbits of few steps; and of secant steps after that, with orbits of many steps.
const LOOKS: u32 = 40u;
const HALVINGS: u32 = 12u;
const FEW_STEPS: u32 = 48u;
const SECANTS: u32 = 6u;
const MANY_STEPS: u32 = ROUND_STEPS;
// For derivatives: first a fraction of the angle, then the distance at which 1/r changes by this fraction.
const APART: Real = 2e-3;
const CHANGE: Real = 0.08;
const NEVER_THERE: Real = -1.0;
const SWALLOWED: Real = 1e30;

struct ShotPlane {
    // The distances of the light and the position from the center.
    from_center: Real,
    to_center: Real,
    // The unit vectors from the center to the light, and perpendicular to it, onward to the position on this side; the angle between both
    // on this side.
    n: Real3,
    t: Real3,
    sweep: Real,
}

fn shot_plane(source: Real3, place: Real3, far_side: bool) -> ShotPlane {
    let a = source - orbit_center();
    let b = place - orbit_center();
    let n = normalize(a);
    let along = dot(b, n);
    var across = b - along * n;
    // If the three points are collinear, any plane will do.
    let any_plane = square_to(n)[0];
    across = select(across, 1e-6 * length(b) * any_plane, length(across) < 1e-6 * length(b));
    let angle = arc_tangent(length(across), along);
    let t = normalize(across);
    return ShotPlane(length(a), length(b), n, select(t, -t, far_side), select(angle, 2.0 * PI - angle, far_side));
}

// Returns the orbit at the angle of the position, for the path that leaves the light at `off` from the line to the center.
fn shot_orbit(plane: ShotPlane, off: Real, steps: u32) -> Orbit {
    let turn = real_sin_cos(off);
    var o = Orbit(1.0 / plane.from_center, turn.y, 0.0, plane.from_center * turn.x, plane.n, plane.t);
    let s = plane.sweep / (Real(steps) * o.h);
    // The rounding error of each sum is added to the next: if two paths nearly coincide, their angle depends on the last digits.
    var rest = Real2(0.0);
    for (var i = 0u; i < steps; i++) {
        let more = orbit_change(o, s) + rest;
        let sum = Real2(opaque(o.u + more.x), opaque(o.w + more.y));
        rest = more - Real2(opaque(sum.x - o.u), opaque(sum.y - o.w));
        o.u = sum.x;
        o.w = sum.y;
        if !(o.u > 0.0) {
            o.u = NEVER_THERE;
            break;
        }
        if orbit_captured(o) {
            o.u = SWALLOWED;
            break;
        }
    }
    o.angle = plane.sweep;
    return o;
}

fn look_angle(k: u32) -> Real {
    let part = (Real(k) + 0.5) / Real(LOOKS);
    return PI * part * part * part;
}

// No path is found twice, so that nothing is stored.
fn forget_shots() {
}

// The whole search is one part.
fn continued_search(search: ShotSearch, source: Real3, place: Real3, k: u32) -> ShotSearch {
    return ShotSearch(shot_at(source, place, k), Real3(0.0), 0.0, 0.0, SEARCHED);
}

// Returns the k-th path, counted over both sides.
fn shot_at(source: Real3, place: Real3, k: u32) -> Shot {
    if !has_room() {
        unfinished = true;
        return NO_SHOT;
    }
    let plane = shot_plane(source, place, (k & 1u) == 1u);
    let wanted = 1.0 / plane.to_center;
    var low: Real = 0.0;
    var high: Real = 0.0;
    var rises = false;
    var before = false;
    var seen = 0u;
    for (var i = 0u; i <= LOOKS; i++) {
        let off = select(look_angle(i), PI, i == LOOKS);
        // A ray straight away from the center never comes around.
        let inside = i < LOOKS && shot_orbit(plane, off, FEW_STEPS).u > wanted;
        if i > 0u && inside != before {
            if seen == (k >> 1u) {
                high = off;
                rises = inside;
                seen += 1u;
                break;
            }
            seen += 1u;
        }
        before = inside;
        low = off;
    }
    if high == 0.0 {
        return NO_SHOT;
    }
    for (var i = 0u; i < HALVINGS; i++) {
        let middle = 0.5 * (low + high);
        let inside = shot_orbit(plane, middle, FEW_STEPS).u > wanted;
        low = select(middle, low, inside == rises);
        high = select(high, middle, inside == rises);
    }
    // The root for many steps may be slightly outside the bracket for few steps.
    var gap = shot_orbit(plane, low, MANY_STEPS).u - wanted;
    var off = high;
    for (var i = 0u; i < SECANTS; i++) {
        let there = shot_orbit(plane, off, MANY_STEPS).u - wanted;
        let next = off - there * (off - low) / select(there - gap, 1.0, there == gap);
        low = off;
        gap = there;
        off = clamp(next, 0.5 * off, min(2.0 * off, PI));
    }
    let shot = shot_along(plane, off, wanted);
    if is_spent() {
        unfinished = true;
        return NO_SHOT;
    }
    return shot;
}

// Returns the path that leaves at this angle, if it is one: between captured and escaping rays there is none.
fn shot_along(plane: ShotPlane, off: Real, wanted: Real) -> Shot {
    let o = shot_orbit(plane, off, MANY_STEPS);
    if abs(o.u - wanted) > 2e-3 * wanted {
        return NO_SHOT;
    }
    let turn = real_sin_cos(off);
    let v = orbit_point(o)[1];
    // A fourth-order difference: wide enough for the last digits not to matter.
    let close = APART * turn.x;
    let roughly = shot_orbit(plane, off + close, MANY_STEPS).u - shot_orbit(plane, off - close, MANY_STEPS).u;
    let apart = clamp(CHANGE * wanted * 2.0 * close / max(abs(roughly), 1e-30), 1e-4 * turn.x, 4e-2 * turn.x);
    let inner = shot_orbit(plane, off + apart, MANY_STEPS).u - shot_orbit(plane, off - apart, MANY_STEPS).u;
    let outer = shot_orbit(plane, off + 2.0 * apart, MANY_STEPS).u - shot_orbit(plane, off - 2.0 * apart, MANY_STEPS).u;
    let slope = (8.0 * inner - outer) / (12.0 * apart);
    // The distance changes with the angle by slope/u², of which the component perpendicular to the path counts. The width of the bundle
    // across the plane is the distance of the position from the line through the center and the light.
    let square = o.h * o.u / length(v);
    let wide = abs(real_sin_cos(plane.sweep).x) / (wanted * turn.x);
    let spread = abs(slope) / (wanted * wanted) * square * wide;
    // The change with half as many steps, a fifteenth of which is the error of the full number.
    let change = abs(o.u - shot_orbit(plane, off, MANY_STEPS / 2u).u) / 15.0;
    let error = (abs(o.u - wanted) + change) / max(abs(slope), 1e-30);
    return Shot(true, turn.x * plane.t - turn.y * plane.n, normalize(v), spread, error);
}
