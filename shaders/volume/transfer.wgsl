// Radiative transfer: the light that matter in volumes emits and absorbs along a path. I/ν³ is constant in vacuum, so that with s, the
// frequency to the matter divided by the frequency to the camera, and the affine parameter λ of light of frequency 1 at the camera,
//
//     I = ∫ j(sν)/s² e^(−T) dλ,    dT = s κ(sν) dλ.
//
// A step of the path is cut into pieces, by the error of the transfer and not by that of the path. Each half of a piece has three Gauss
// points; where it is opaque, its source function j/κ is linear in the optical depth instead, which is exact for matter of one temperature
// however opaque it is. Sums of the same points, which vanish for cubic and for linear functions, estimate the error.

struct Transfer {
    // The radius of the horizon, if there is one.
    horizon: Real,
    // The largest error of a piece, relative to the light and to the optical depth so far.
    tolerance: f32,
    // The inverse of the distance from the center of the law within which there are volumes; 0 if they are everywhere.
    edge: Real,
    // The angle, in radians, over which orbits are interpolated.
    arc: f32,
    // The coordinate time at the camera.
    time: f32,
    // The light that is white in pictures.
    white: f32,
    // The last stable orbits: the distance from the axis, and E and L.
    last_prograde: Real3,
    last_retrograde: Real3,
    // The axes of formulas.
    first: Real3,
    second: Real3,
    third: Real3,
}

var<uniform> transfer: Transfer;

// I and T of each channel so far.
struct Light {
    light: array<Real, CHANNELS>,
    depth: array<Real, CHANNELS>,
}

// j/s² and s κ, per unit of the step.
struct Matter {
    emission: array<Real, CHANNELS>,
    absorption: array<Real, CHANNELS>,
}

var<private> transferred: Light;
// True where matter cannot be as its formulas state: negative, not a number, or faster than light.
var<private> transfer_invalid: bool;
var<private> transfer_unsettled: bool;
// The errors of the light and of the depth by pieces that could not be cut further.
var<private> transfer_doubts: array<Real2, CHANNELS>;

// The Gauss points of half a piece, the rule that runs up to each of them, and the whole rule.
const GAUSS_POINTS: Real3 = Real3(0.1127016653792583, 0.5, 0.8872983346207417);
const GAUSS_TO_FIRST: Real3 = Real3(0.1388888888888889, -0.03597666752493890, 0.009789444015308326);
const GAUSS_TO_MIDDLE: Real3 = Real3(0.3002631949808646, 0.2222222222222222, -0.02248541720308681);
const GAUSS_TO_LAST: Real3 = Real3(0.2679883337624694, 0.4804211119693833, 0.1388888888888889);
const GAUSS_WEIGHTS: Real3 = Real3(0.2777777777777778, 0.4444444444444444, 0.2777777777777778);
// The sums over the first half that vanish for quartic, cubic and linear functions; in the second half they are mirrored, and the first is
// negative.
const NULL_QUARTIC: Real3 = Real3(0.0297155667, -0.1721331889, 0.5297172973);
const NULL_CUBIC: Real3 = Real3(0.1361496700, -0.4444444444, 0.3082947744);
const NULL_LINEAR: Real3 = Real3(0.2777777778, 0.0, -0.2777777778);
// After this number of pieces of a part that are not easy, the allowed error of each grows, because rounding may not allow less; and then
// none is cut.
const MANY_PIECES: u32 = 512u;
const TRANSFER_PIECES: u32 = 1024u;
// The least size of a piece, in rounding errors of positions.
const LEAST_PIECE: Real = 24.0;
// The part of that down to which surfaces of volumes are looked for.
const REGION_PART: Real = 0.1;
// Matter behind this optical depth is not seen.
const OPAQUE: Real = 80.0;
// The optical depth of half a piece from which its source function is taken as linear.
const THICK: Real = 1.0;

// The light that a piece adds, as the camera sees it, and its depth; their errors, and the largest of these in units of those that count.
struct TransferPiece {
    added: Light,
    errors: array<Real2, CHANNELS>,
    error: Real,
}

fn transfer_exp(depth: Real) -> Real {
    return real_exp(-min(depth, OPAQUE));
}

// Returns a sum's error from the sums that vanish for smooth functions: of a smooth one the higher are much smaller. Two of about the same
// order are combined, because one may vanish by chance (Berntsen and Espelid 1991).
fn null_error(nulls: Real3) -> Real {
    let c = length(nulls.xy);
    return c * min(1.0, c / max(abs(nulls.z), 1e-30));
}

// Returns the light and the depth so far to which errors are relative.
fn light_that_counts(k: u32, added: Light) -> Real2 {
    let light = earlier_light(k) + transferred.light[k] + added.light[k] + 1e-30;
    return Real2(light, clamp(transferred.depth[k] + added.depth[k], LEAST_DEPTH, select(Real(1.0), 1e30, KEEPS_DEPTH)));
}

// Returns the weight of the errors of depths: that of the light behind, unless they are results.
fn depth_weight(k: u32) -> Real {
    return select(transfer_exp(transferred.depth[k]), 1.0, KEEPS_DEPTH);
}

// Notes whether the light so far is less accurate than it should be.
fn note_doubts() {
    for (var k = 0u; k < CHANNELS; k++) {
        let allowed = Real(transfer.tolerance) * light_that_counts(k, Light());
        transfer_unsettled = transfer_unsettled || any(transfer_doubts[k] > allowed);
        transfer_doubts[k] = Real2(0.0);
    }
}

// The part of a piece beyond its first and its last point.
const BEYOND_POINTS: Real = 0.0563508327;

// Returns the errors of a piece by edges of matter between its ends and the points next to them, `outer`.
fn edge_error(k: u32, added: Light, size: Real, ends: array<Matter, 2>, outer: array<Matter, 2>) -> Real2 {
    let depth = transferred.depth[k];
    let first = transfer_exp(depth) * edge_of(ends[0], outer[0], k);
    return BEYOND_POINTS * size * (first + transfer_exp(depth + added.depth[k]) * edge_of(ends[1], outer[1], k));
}

// Returns the sum of both if one of them is 0.
fn edge_of(one: Matter, two: Matter, k: u32) -> Real2 {
    let a = Real2(one.emission[k], one.absorption[k]);
    let b = Real2(two.emission[k], two.absorption[k]);
    return select(Real2(0.0), a + b, min(a, b) <= Real2(0.0));
}

// Returns a piece of a step between two fractions of it. `within` marks the volumes that contain it.
fn transfer_piece(step: Stretch, within: u32, start: Real, size: Real) -> TransferPiece {
    var piece: TransferPiece;
    // Sums that vanish for smooth functions, of the light and of the depth.
    var nulls: array<Real3, CHANNELS>;
    var depth_nulls: array<Real3, CHANNELS>;
    var rough: array<Real, CHANNELS>;
    // The light that passes the matter before a half.
    var passing: array<Real, CHANNELS>;
    if ABSORBS_VOLUMES {
        for (var k = 0u; k < CHANNELS; k++) {
            passing[k] = transfer_exp(transferred.depth[k]);
        }
    }
    let h = 0.5 * size;
    var ends: array<Matter, 2>;
    var outer: array<Matter, 2>;
    if HAS_EDGES {
        ends[0] = matter_at(step, within, start);
        ends[1] = matter_at(step, within, start + size);
    }
    // The ends do not count as points at which matter is seen, because the sums do not contain them.
    if BOUNDS_MATTER {
        begin_seen();
    }
    var half = 0u;
    loop {
        let a = start + Real(half) * h;
        let first = matter_at(step, within, a + GAUSS_POINTS.x * h);
        let middle = matter_at(step, within, a + GAUSS_POINTS.y * h);
        let last = matter_at(step, within, a + GAUSS_POINTS.z * h);
        if HAS_EDGES {
            if half == 0u {
                outer[0] = first;
            } else {
                outer[1] = last;
            }
        }
        let quartic = select(NULL_QUARTIC, -NULL_QUARTIC.zyx, half == 1u);
        let cubic = select(NULL_CUBIC, NULL_CUBIC.zyx, half == 1u);
        let linear = select(NULL_LINEAR, NULL_LINEAR.zyx, half == 1u);
        for (var k = 0u; k < CHANNELS; k++) {
            let j = h * Real3(first.emission[k], middle.emission[k], last.emission[k]);
            if !ABSORBS_VOLUMES {
                piece.added.light[k] += dot(GAUSS_WEIGHTS, j);
                nulls[k] += Real3(dot(quartic, j), dot(cubic, j), dot(linear, j));
                continue;
            }
            let dims = h * Real3(first.absorption[k], middle.absorption[k], last.absorption[k]);
            let depth = dot(GAUSS_WEIGHTS, dims);
            let at = max(Real3(dot(GAUSS_TO_FIRST, dims), dot(GAUSS_TO_MIDDLE, dims), dot(GAUSS_TO_LAST, dims)), Real3(0.0));
            let passes = transfer_exp(depth);
            let front = passing[k];
            if depth > THICK {
                let source = j / max(dims, Real3(1e-30));
                let slope = (source.z - source.x) / max(at.z - at.x, 1e-30);
                let near = max(source.x - slope * at.x, 0.0);
                let far = max(source.z + slope * (depth - at.z), 0.0);
                let share = (1.0 - passes) / depth - passes;
                piece.added.light[k] += front * (near * (1.0 - passes - share) + far * share);
                rough[k] += front * (abs(source.y - source.x - slope * (at.y - at.x)) + 0.25 * abs(source.x - near));
            } else {
                let seen = front * j * Real3(real_exp(-at.x), real_exp(-at.y), real_exp(-at.z));
                piece.added.light[k] += dot(GAUSS_WEIGHTS, seen);
                nulls[k] += Real3(dot(quartic, seen), dot(cubic, seen), dot(linear, seen));
            }
            depth_nulls[k] += Real3(dot(quartic, dims), dot(cubic, dims), dot(linear, dims));
            piece.added.depth[k] += depth;
            passing[k] = front * passes;
        }
        half += 1u;
        continuing {
            break if half == 2u;
        }
    }
    for (var k = 0u; k < CHANNELS; k++) {
        piece.errors[k].x = null_error(nulls[k]) + rough[k];
        if ABSORBS_VOLUMES {
            piece.errors[k].y = depth_weight(k) * null_error(depth_nulls[k]);
        }
        if HAS_EDGES {
            piece.errors[k] += edge_error(k, piece.added, size, ends, outer);
        }
        let relative = piece.errors[k] / light_that_counts(k, piece.added);
        piece.error = max(piece.error, max(relative.x, relative.y));
    }
    return piece;
}

fn add_piece(piece: TransferPiece) {
    for (var k = 0u; k < CHANNELS; k++) {
        transferred.light[k] += piece.added.light[k];
        transferred.depth[k] += piece.added.depth[k];
    }
}

// Notes a piece that could not be cut further; after too many, all of its light is in doubt.
fn doubt_piece(piece: TransferPiece, is_tired: bool) {
    for (var k = 0u; k < CHANNELS; k++) {
        let all = light_that_counts(k, Light());
        transfer_doubts[k] += select(piece.errors[k], all, is_tired);
    }
}

// True while something behind may be seen.
fn transfer_lasts() -> bool {
    if KEEPS_DEPTH {
        return true;
    }
    var least = transferred.depth[0];
    for (var k = 1u; k < CHANNELS; k++) {
        least = min(least, transferred.depth[k]);
    }
    return least < TRANSFER_END;
}

const TRANSFER_END: Real = 24.0;

// Returns the size of the shortest pieces, to whose light the rounding of positions adds a few percent.
fn transfer_shortest(extent: Real2, until: Real) -> Real {
    return LEAST_PIECE * LAST_PART * until * max(1.0, extent.y / max(extent.x, 1e-30));
}

// Adds the light of a step from its start to the fraction `until`: of one part after another that is in the same volumes. Loops are tested
// at their ends, because software drivers run the rest of a loop's body once more after a test at its start.
fn transfer_step(step: Stretch, until: Real) {
    var a: Real = 0.0;
    var size = until;
    var place = region_place(step, 0.0);
    if BOUNDS_MATTER {
        begin_bounds();
    }
    let extent = stretch_extent(step, until);
    let shortest = transfer_shortest(extent, until);
    loop {
        var end = select(a + size, until, size > 0.9999 * (until - a) || is_spent());
        var at = region_place(step, end);
        let cut = region_cut(step, place, at, a, end);
        if cut.until < end {
            end = cut.until;
            at = region_behind(step, cut);
        }
        let own = end - a;
        let shortens = cut.unclear && own > REGION_PART * shortest && !is_spent();
        if cut.within != 0u && !shortens && transfer_lasts() {
            var longest = until;
            if HAS_GRIDS {
                longest = max(until * volume_cells(cut.within) / max(extent.x, 1e-30), shortest);
            }
            transfer_part(step, cut.within, a, end, Real2(shortest, longest));
        }
        let onward = max(size, select(Real(2.0), 8.0, cut.within == 0u) * own);
        size = select(onward, 0.5 * own, shortens);
        if !shortens {
            a = end;
            place = at;
        }
        continuing {
            break if a >= until;
        }
    }
}

// Adds the light of a part of a step, piece by piece; `within` marks the volumes that contain it, and `sizes` are the least and the greatest
// size of a piece. One that is as short as it can be, or that follows too many others, counts whether its error is small or not.
fn transfer_part(step: Stretch, within: u32, start: Real, end: Real, sizes: Real2) {
    var a = start;
    var size = min(end - start, sizes.y);
    var pieces = 0u;
    loop {
        let is_last = size > 0.9999 * (end - a) || is_spent();
        let own = select(size, end - a, is_last);
        let is_tired = pieces > TRANSFER_PIECES || is_spent();
        let piece = transfer_piece(step, within, a, own);
        let allowed = Real(transfer.tolerance) * Real(exp2(f32(max(pieces, MANY_PIECES) - MANY_PIECES) / 32.0));
        var agrees = piece.error <= allowed;
        if BOUNDS_MATTER {
            agrees = agrees && !matter_hides(within, piece, own);
        }
        let is_final = agrees || own <= sizes.x || is_tired;
        if is_final {
            add_piece(piece);
            if !agrees || pieces > MANY_PIECES {
                doubt_piece(piece, is_tired && !agrees);
            }
            a = select(a + own, end, is_last);
        }
        let easy = is_tired || 16.0 * piece.error < allowed;
        pieces += select(0u, 1u, is_final && !easy);
        size = min(select(0.5 * own, max(size, select(Real(1.0), 2.0, easy) * own), is_final), sizes.y);
        continuing {
            break if a >= end || !transfer_lasts();
        }
    }
}

// Adds the light of matter between the end of a captured ray and the horizon. There light and absorption grow or fall as powers of the
// height above it, because frequencies do.
fn transfer_tail(step: Stretch, until: Real) {
    let place = region_place(step, until);
    var within = 0u;
    for (var v = 0u; v < VOLUMES; v++) {
        within |= select(0u, 1u << v, place.gaps[v] < 0.0);
    }
    var spot = stretch_spot(step, until);
    let left = stretch_left(step, until);
    if within == 0u || !(left > 0.0 && left < 1e30) {
        return;
    }
    let here = matter_of(spot, within);
    spot.higher = 0.7071067811865476;
    let above = matter_of(spot, within);
    for (var k = 0u; k < CHANNELS; k++) {
        let passes = transfer_exp(transferred.depth[k]);
        transferred.light[k] += passes * tail_sum(here.emission[k], above.emission[k], left);
        transferred.depth[k] += tail_sum(here.absorption[k], above.absorption[k], left);
    }
}

// The lowest power of the height that has a sum.
const TAIL_POWER: Real = -0.95;

// Returns the sum to the horizon of a quantity, from its values here and at twice the height; `left` is the distance at the rate here.
fn tail_sum(here: Real, above: Real, left: Real) -> Real {
    if here <= 0.0 || above <= 0.0 {
        return 0.0;
    }
    let power = log_ratio(above, here) / 0.6931471805599453;
    transfer_invalid = transfer_invalid || power < TAIL_POWER;
    return here * left / (1.0 + max(power, TAIL_POWER));
}
