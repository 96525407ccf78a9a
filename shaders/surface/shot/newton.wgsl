// Finds paths from a light to a position under any law, by the Newton method. The unknowns are two angles about a first direction; the
// offset of the path from the position, perpendicular to the path at its nearest point, must vanish. Two neighboring paths give the
// derivative. Each of several first directions may lead to a different path: straight; past each source of the law on its other side, at
// three distances from it; or, if the law has no source, to the left, right, above and below; and all around, for `bentray light`.

struct Aim {
    position: Real3,
}

// The sources of the law; if there are none, one unused entry.
var<uniform> aims: array<Aim, AIM_COUNT>;

const NEWTON_STEPS: u32 = 12u;
const SHORTENINGS: u32 = 4u;
// After this many steps, a path that is still off by HOPELESS of the distance between light and position is abandoned.
const HOPELESS_AT: u32 = 5u;
const HOPELESS: Real = 0.2;
// The largest step, the angle between neighbors, the one between the rays of the bundle, and the one within which paths are equal, in
// radians.
const LONGEST: Real = 0.3;
const NEIGHBOUR: Real = 2e-3;
const BUNDLE: Real = 4e-3;
const SAME: f32 = 2e-3;
// A path is followed up to this multiple of the distances of both ends from each other and from the center of the bounding sphere.
const LONGEST_PATH: Real = 5.0;
// The tangents of the angles of first directions to the sides.
const TILT: Real = 1.0;
const STEEP: Real = 6.0;
// The fraction of a turn from one of the directions all around to the next.
const GOLDEN: f32 = 0.381966;
// The distance past a source, relative to its distance from the straight line.
const BEYOND: array<Real, 3> = array<Real, 3>(1.0, 0.35, 0.1);
// Relative to the distance between light and position: a path has converged within a few roundings, and is accepted at all within this.
const ROUNDINGS: Real = 10.0;
const NEAR_ENOUGH: Real = 1e-4;
// Within this distance whole steps converge, or rounding stops them.
const CLOSE: Real = 1e-3;

// The directions found for a light so far.
var<private> found_directions: array<vec3f, SHOTS>;
var<private> found_count: u32;

// A path at its nearest point to the position.
struct Nearest {
    offset: Real3,
    v: Real3,
    gap: Real,
    // The length of the path up to there, to within a segment.
    passed: Real,
}

// Returns the largest length of a path, because a path may orbit forever.
fn longest_path(source: Real3, place: Real3) -> Real {
    return LONGEST_PATH * (distance(source, place) + distance(source, bound.center) + distance(place, bound.center));
}

// Returns the length up to which neighbors of a path are followed: slightly more than it takes to pass the position.
fn neighbor_length(search: ShotSearch) -> Real {
    return 1.25 * search.passed + 2.0 * search.gap;
}

fn nearest_to(source: Real3, d: Real3, place: Real3, longest: Real) -> Nearest {
    rejoin();
    var ray = shot_start(source, d);
    var best = infinite();
    var from_ray = ray;
    var to_ray = ray;
    var at: Real = 0.0;
    var passed: Real = 0.0;
    var passed_there: Real = 0.0;
    for (var k = 0u; k < schedule.max_segments && passed < longest && has_room(); k++) {
        var next = ray;
        let s = follow_segment(&next);
        passed += distance(s.x0, s.x1);
        let t = nearest_fraction(s, place);
        let gap = distance(segment_point(s, t), place);
        // The start of a path that comes back is not its nearest point, however far it misses the position.
        if t > 0.0 && gap < best {
            best = gap;
            from_ray = ray;
            to_ray = next;
            at = t;
            passed_there = passed;
        }
        if open_status(s, next.tau, 0u) != ALIVE {
            break;
        }
        ray = next;
    }
    return nearest_on(from_ray, to_ray, at, place, passed_there);
}

// Retakes the step up to the nearest point: the position and direction of the arc itself would be off by up to 3e-4.
fn nearest_on(start: Ray, end: Ray, t: Real, place: Real3, passed: Real) -> Nearest {
    let size = own_size(start, end);
    var h = own_fraction(start.phase, end.phase, t) * size;
    var p = retaken_step(start.phase, h);
    for (var i = 0u; i < 3u; i++) {
        let v = p[1].xyz;
        h = clamp(h - dot(p[0].xyz - place, v) / (dot(v, v) * own_pace(p)), 0.0, size);
        p = retaken_step(start.phase, h);
    }
    let offset = p[0].xyz - place;
    return Nearest(offset, normalize(p[1].xyz), length(offset), passed);
}

fn tilted(d: Real3, base: mat2x3<Real>, by: Real2) -> Real3 {
    return normalize(d + by.x * base[0] + by.y * base[1]);
}

fn first_direction(source: Real3, place: Real3, k: u32) -> Real3 {
    let straight = normalize(place - source);
    if k == 0u {
        return straight;
    }
    if k >= USUAL_SHOTS {
        return direction_around(straight, k - USUAL_SHOTS);
    }
    if k + 1u == USUAL_SHOTS && !HAS_AIMS {
        return -straight;
    }
    if HAS_AIMS {
        let center = aims[(k - 1u) / 3u].position;
        let off = center - source - dot(center - source, straight) * straight;
        // Strong bending needs a direction further out, weak bending one nearer to the source.
        return normalize(center + BEYOND[(k - 1u) % 3u] * off - source);
    }
    let base = square_to(straight);
    let tilt = select(TILT, STEEP, k > 4u);
    let angle = select(-tilt, tilt, (k & 1u) == 1u);
    return tilted(straight, base, select(Real2(angle, 0.0), Real2(0.0, angle), ((k - 1u) & 2u) != 0u));
}

// Returns the i-th of uniformly distributed directions, on a spiral of equal areas around d by golden angles.
fn direction_around(d: Real3, i: u32) -> Real3 {
    let base = square_to(d);
    let along = 1.0 - (2.0 * Real(i) + 1.0) / Real(max(SHOTS - USUAL_SHOTS, 1u));
    let turn = real_sin_cos(2.0 * PI * Real(fract(GOLDEN * f32(i))));
    return along * d + sqrt(1.0 - along * along) * (turn.y * base[0] + turn.x * base[1]);
}

fn forget_shots() {
    found_count = 0u;
}

fn shot_at(source: Real3, place: Real3, k: u32) -> Shot {
    var search = begun_search(source, place, k);
    while search.parts <= NEWTON_STEPS {
        search = nearer_search(search, source, place);
    }
    return ended_search(search, source, place);
}

// Continues the search by one part.
fn continued_search(search: ShotSearch, source: Real3, place: Real3, k: u32) -> ShotSearch {
    var next = search;
    if search.parts == 0u {
        next = begun_search(source, place, k);
    } else if search.parts <= NEWTON_STEPS {
        next = nearer_search(search, source, place);
    } else {
        next.shot = ended_search(search, source, place);
        next.parts = SEARCHED;
    }
    return next;
}

fn begun_search(source: Real3, place: Real3, k: u32) -> ShotSearch {
    let d = first_direction(source, place, k);
    return with_path(ShotSearch(NO_SHOT, Real3(0.0), 0.0, 0.0, 1u), d, nearest_to(source, d, place, longest_path(source, place)));
}

fn with_path(search: ShotSearch, d: Real3, path: Nearest) -> ShotSearch {
    return ShotSearch(Shot(false, d, path.v, 0.0, 0.0), path.offset, path.gap, path.passed, search.parts);
}

// Takes one Newton step.
fn nearer_search(search: ShotSearch, source: Real3, place: Real3) -> ShotSearch {
    let far = distance(source, place);
    let d = search.shot.leaves;
    var over = search;
    over.parts = NEWTON_STEPS + 1u;
    let there = search.gap <= ROUNDINGS * LAST_PART * far;
    if there || (search.parts > HOPELESS_AT && search.gap > HOPELESS * far) {
        return over;
    }
    let base = square_to(d);
    let across = square_to(search.shot.arrives);
    let longest = neighbor_length(search);
    let a = nearest_to(source, tilted(d, base, Real2(NEIGHBOUR, 0.0)), place, longest).offset - search.offset;
    let b = nearest_to(source, tilted(d, base, Real2(0.0, NEIGHBOUR)), place, longest).offset - search.offset;
    let column_a = Real2(dot(a, across[0]), dot(a, across[1]));
    let column_b = Real2(dot(b, across[0]), dot(b, across[1]));
    let off = Real2(dot(search.offset, across[0]), dot(search.offset, across[1]));
    let det = column_a.x * column_b.y - column_a.y * column_b.x;
    if det == 0.0 {
        return over;
    }
    var step = (-NEIGHBOUR / det) * Real2(off.x * column_b.y - off.y * column_b.x, off.y * column_a.x - off.x * column_a.y);
    step *= min(1.0, LONGEST / max(length(step), 1e-30));
    let shortenings = select(SHORTENINGS, 1u, search.gap < CLOSE * far);
    for (var j = 0u; j < shortenings; j++) {
        let trial = tilted(d, base, step);
        let path = nearest_to(source, trial, place, longest);
        if path.gap < search.gap {
            var nearer = with_path(search, trial, path);
            nearer.parts += 1u;
            return nearer;
        }
        step *= 0.5;
    }
    return over;
}

fn ended_search(search: ShotSearch, source: Real3, place: Real3) -> Shot {
    var shot = NO_SHOT;
    if search.gap <= NEAR_ENOUGH * distance(source, place) && is_new(vec3f(search.shot.leaves)) {
        shot = search.shot;
        shot.found = true;
        shot.spread = bundle_spread(search, source, place);
        shot.error = search.gap / sqrt(max(shot.spread, 1e-30));
    }
    // A path or its bundle may have ended because the loop limit was reached; then neither result is known.
    rejoin();
    if !has_room() {
        unfinished = true;
        return NO_SHOT;
    }
    return shot;
}

fn is_new(d: vec3f) -> bool {
    for (var i = 0u; i < found_count; i++) {
        if distance(found_directions[i], d) < SAME {
            return false;
        }
    }
    found_directions[found_count] = d;
    found_count += 1u;
    return true;
}

// Computes the divergence of the ray bundle from a neighbor on each of four sides; in 64 bits also from one twice as far out, for a
// difference of the fourth order.
fn bundle_spread(search: ShotSearch, source: Real3, place: Real3) -> Real {
    var columns = bundle_change(search, source, place, BUNDLE);
    if LAST_PART < 1e-10 {
        columns = (4.0 / 3.0) * columns - (1.0 / 3.0) * bundle_change(search, source, place, 2.0 * BUNDLE);
    }
    let across = square_to(search.shot.arrives);
    let a = Real2(dot(columns[0], across[0]), dot(columns[0], across[1]));
    let b = Real2(dot(columns[1], across[0]), dot(columns[1], across[1]));
    return abs(a.x * b.y - a.y * b.x);
}

// Returns the derivative of the offset at the position by the two angles of the direction at the light.
fn bundle_change(search: ShotSearch, source: Real3, place: Real3, apart: Real) -> mat2x3<Real> {
    let d = search.shot.leaves;
    let base = square_to(d);
    let longest = neighbor_length(search);
    var columns = mat2x3<Real>(Real3(0.0), Real3(0.0));
    for (var i = 0u; i < 4u; i++) {
        let side = select(apart, -apart, (i & 1u) == 1u);
        let to_side = select(Real2(side, 0.0), Real2(0.0, side), i > 1u);
        let offset = nearest_to(source, tilted(d, base, to_side), place, longest).offset / (2.0 * side);
        columns[0] += select(Real3(0.0), offset, i < 2u);
        columns[1] += select(Real3(0.0), offset, i > 1u);
    }
    return columns;
}
