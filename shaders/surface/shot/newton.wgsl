// Paths under any law, by Newton's method: two angles about a first direction are unknown, and the offset of the path from the place, square
// to the path where it is nearest, shall vanish. Two neighbours travel along for the derivative. Each of several first directions may lead to
// a path of its own: straight, past each of the law's sources on its other side, at three distances from it, or, where it has none, to the left, right, above and below.

struct Aim {
    position: Real3,
}

// The sources of the law, or none at all, and then one that nobody looks at.
@group(0) @binding(144) var<uniform> aims: array<Aim, AIM_COUNT>;

const NEWTON_STEPS: u32 = 12u;
const SHORTENINGS: u32 = 4u;
// After so many steps a path that is still this far off, of the distance between light and place, is given up.
const HOPELESS_AT: u32 = 5u;
const HOPELESS: Real = 0.2;
// Radians: the most in one step, between neighbours, between those that the spread is taken from, and between paths that are one.
const LONGEST: Real = 0.3;
const NEIGHBOUR: Real = 2e-3;
const BUNDLE: Real = 4e-3;
const SAME: f32 = 2e-3;
// A path this much longer than the distances of both ends from each other and from the bounding sphere's middle is followed no further.
const LONGEST_PATH: Real = 5.0;
// Tangents of the angles of first directions to the sides.
const TILT: Real = 1.0;
const STEEP: Real = 6.0;
// How far past a source, in parts of its distance from the straight line.
const BEYOND: array<Real, 3> = array<Real, 3>(1.0, 0.35, 0.1);
// Of the distance between light and place: a path this near is there.
const THERE: Real = 2e-6;
const NEAR_ENOUGH: Real = 1e-4;

// The directions found for a light so far.
var<private> found_directions: array<vec3f, SHOTS>;
var<private> found_count: u32;

// A path where it is nearest to the place.
struct Nearest {
    offset: Real3,
    v: Real3,
    gap: Real,
}

fn nearest_to(source: Real3, d: Real3, place: Real3) -> Nearest {
    var ray = shot_start(source, d);
    let far = distance(source, place);
    var best = far;
    var from_ray = ray;
    var to_ray = ray;
    var at: Real = 0.0;
    // A path may go round for ever.
    let longest = LONGEST_PATH * (far + distance(source, bound.center) + distance(place, bound.center));
    var passed: Real = 0.0;
    for (var k = 0u; k < schedule.max_segments && passed < longest && shot_has_room(); k++) {
        work += 1u;
        var next = ray;
        let s = follow_segment(&next);
        passed += distance(s.x0, s.x1);
        let t = nearest_fraction(s, place);
        let gap = distance(segment_point(s, t), place);
        if gap < best {
            best = gap;
            from_ray = ray;
            to_ray = next;
            at = t;
        }
        if open_status(s, next.tau, 0u) != ALIVE {
            break;
        }
        ray = next;
    }
    return nearest_on(from_ray, to_ray, at, place);
}

// The step retaken to where it is nearest: the arc's own place and direction would be off by up to 3e-4.
fn nearest_on(start: Ray, end: Ray, t: Real, place: Real3) -> Nearest {
    let size = own_size(start, end);
    var h = own_fraction(start.phase, end.phase, t) * size;
    var p = retaken_step(start.phase, h);
    for (var i = 0u; i < 3u; i++) {
        work += 1u;
        let v = p[1].xyz;
        h = clamp(h - dot(p[0].xyz - place, v) / (dot(v, v) * own_pace(p)), 0.0, size);
        p = retaken_step(start.phase, h);
    }
    let offset = p[0].xyz - place;
    return Nearest(offset, normalize(p[1].xyz), length(offset));
}

fn tilted(d: Real3, base: mat2x3<Real>, by: Real2) -> Real3 {
    return normalize(d + by.x * base[0] + by.y * base[1]);
}

fn first_direction(source: Real3, place: Real3, k: u32) -> Real3 {
    let straight = normalize(place - source);
    if k == 0u {
        return straight;
    }
    if k + 1u == SHOTS && !HAS_AIMS {
        return -straight;
    }
    if HAS_AIMS {
        let center = aims[(k - 1u) / 3u].position;
        let off = center - source - dot(center - source, straight) * straight;
        // The stronger it bends, the further out; the less, the nearer to it.
        return normalize(center + BEYOND[(k - 1u) % 3u] * off - source);
    }
    let base = square_to(straight);
    let tilt = select(TILT, STEEP, k > 4u);
    let angle = select(-tilt, tilt, (k & 1u) == 1u);
    return tilted(straight, base, select(Real2(angle, 0.0), Real2(0.0, angle), ((k - 1u) & 2u) != 0u));
}

fn forget_shots() {
    found_count = 0u;
}

fn shot_at(source: Real3, place: Real3, k: u32) -> Shot {
    let far = distance(source, place);
    var d = first_direction(source, place, k);
    var best = nearest_to(source, d, place);
    for (var i = 0u; i < NEWTON_STEPS && best.gap > THERE * far; i++) {
        work += 1u;
        if i == HOPELESS_AT && best.gap > HOPELESS * far {
            break;
        }
        let base = square_to(d);
        let across = square_to(best.v);
        let a = nearest_to(source, tilted(d, base, Real2(NEIGHBOUR, 0.0)), place).offset - best.offset;
        let b = nearest_to(source, tilted(d, base, Real2(0.0, NEIGHBOUR)), place).offset - best.offset;
        let column_a = Real2(dot(a, across[0]), dot(a, across[1]));
        let column_b = Real2(dot(b, across[0]), dot(b, across[1]));
        let off = Real2(dot(best.offset, across[0]), dot(best.offset, across[1]));
        let det = column_a.x * column_b.y - column_a.y * column_b.x;
        if det == 0.0 {
            break;
        }
        var step = (-NEIGHBOUR / det) * Real2(off.x * column_b.y - off.y * column_b.x, off.y * column_a.x - off.x * column_a.y);
        step *= min(1.0, LONGEST / max(length(step), 1e-30));
        var nearer = false;
        for (var j = 0u; j < SHORTENINGS && !nearer; j++) {
            work += 1u;
            let trial = tilted(d, base, step);
            let there = nearest_to(source, trial, place);
            nearer = there.gap < best.gap;
            if nearer {
                best = there;
                d = trial;
            }
            step *= 0.5;
        }
        if !nearer {
            break;
        }
    }
    var shot = NO_SHOT;
    if best.gap <= NEAR_ENOUGH * far && is_new(vec3f(d)) {
        shot = Shot(true, d, best.v, bundle_spread(source, d, place, best.v));
    }
    // A path or its bundle may have ended for want of room.
    unfinished = unfinished || !shot_has_room();
    return shot;
}

fn is_new(d: vec3f) -> bool {
    for (var i = 0u; i < found_count; i++) {
        work += 1u;
        if distance(found_directions[i], d) < SAME {
            return false;
        }
    }
    found_directions[found_count] = d;
    found_count += 1u;
    return true;
}

// By a neighbour on each of four sides.
fn bundle_spread(source: Real3, d: Real3, place: Real3, v: Real3) -> Real {
    let base = square_to(d);
    let across = square_to(v);
    var columns = mat2x3<Real>(Real3(0.0), Real3(0.0));
    for (var i = 0u; i < 4u; i++) {
        work += 1u;
        let side = select(BUNDLE, -BUNDLE, (i & 1u) == 1u);
        let to_side = select(Real2(side, 0.0), Real2(0.0, side), i > 1u);
        let offset = nearest_to(source, tilted(d, base, to_side), place).offset / (2.0 * side);
        columns[0] += select(Real3(0.0), offset, i < 2u);
        columns[1] += select(Real3(0.0), offset, i > 1u);
    }
    let a = Real2(dot(columns[0], across[0]), dot(columns[0], across[1]));
    let b = Real2(dot(columns[1], across[0]), dot(columns[1], across[1]));
    return abs(a.x * b.y - a.y * b.x);
}
