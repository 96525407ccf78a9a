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
    // The light that is too faint to count.
    floor: f32,
    // The coordinate time at the camera.
    time: f32,
    // The light that is white in pictures.
    white: f32,
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

// The Gauss points of half a piece, the rule that runs up to each of them, and the whole rule.
const GAUSS_POINTS: Real3 = Real3(0.1127016653792583, 0.5, 0.8872983346207417);
const GAUSS_TO_FIRST: Real3 = Real3(0.1388888888888889, -0.03597666752493890, 0.009789444015308326);
const GAUSS_TO_MIDDLE: Real3 = Real3(0.3002631949808646, 0.2222222222222222, -0.02248541720308681);
const GAUSS_TO_LAST: Real3 = Real3(0.2679883337624694, 0.4804211119693833, 0.1388888888888889);
const GAUSS_WEIGHTS: Real3 = Real3(0.2777777777777778, 0.4444444444444444, 0.2777777777777778);
// The sums over the first half that vanish for cubic and for linear functions; in the second half they are mirrored.
const NULL_CUBIC: Real3 = Real3(0.1361496700, -0.4444444444, 0.3082947744);
const NULL_LINEAR: Real3 = Real3(0.2777777778, 0.0, -0.2777777778);
// The largest number of pieces of a step, and the least size of one, in units of rounding errors of the step.
const TRANSFER_PIECES: u32 = 4096u;
const LEAST_PIECE: Real = 8.0;
// Matter behind this optical depth is not seen.
const OPAQUE: Real = 80.0;
// The optical depth of half a piece from which its source function is taken as linear.
const THICK: Real = 1.0;

// The light of a piece, its depth, and their errors.
struct TransferPiece {
    sum: Light,
    error: Real,
}

fn transfer_exp(depth: Real) -> Real {
    return real_exp(-min(depth, OPAQUE));
}

// Returns a sum's error from the sums that vanish for smooth functions: of a smooth one the higher is much smaller.
fn null_error(cubic: Real, linear: Real) -> Real {
    let c = abs(cubic);
    return c * min(1.0, c / max(abs(linear), 1e-30));
}

// Returns a piece of a step between two fractions of it. `within` marks the volumes that contain it.
fn transfer_piece(step: Stretch, within: u32, start: Real, size: Real) -> TransferPiece {
    var piece = TransferPiece(transferred, 0.0);
    var nulls: array<Real4, CHANNELS>;
    var rough: array<Real, CHANNELS>;
    let h = 0.5 * size;
    var half = 0u;
    loop {
        let a = start + Real(half) * h;
        let first = matter_at(step, within, a + GAUSS_POINTS.x * h);
        let middle = matter_at(step, within, a + GAUSS_POINTS.y * h);
        let last = matter_at(step, within, a + GAUSS_POINTS.z * h);
        let cubic = select(NULL_CUBIC, NULL_CUBIC.zyx, half == 1u);
        let linear = select(NULL_LINEAR, NULL_LINEAR.zyx, half == 1u);
        for (var k = 0u; k < CHANNELS; k++) {
            let j = h * Real3(first.emission[k], middle.emission[k], last.emission[k]);
            if !ABSORBS_VOLUMES {
                piece.sum.light[k] += dot(GAUSS_WEIGHTS, j);
                nulls[k] += Real4(dot(cubic, j), dot(linear, j), 0.0, 0.0);
                continue;
            }
            let dims = h * Real3(first.absorption[k], middle.absorption[k], last.absorption[k]);
            let depth = dot(GAUSS_WEIGHTS, dims);
            let before = piece.sum.depth[k];
            let at = max(Real3(dot(GAUSS_TO_FIRST, dims), dot(GAUSS_TO_MIDDLE, dims), dot(GAUSS_TO_LAST, dims)), Real3(0.0));
            if depth > THICK {
                let source = j / max(dims, Real3(1e-30));
                let slope = (source.z - source.x) / max(at.z - at.x, 1e-30);
                let near = max(source.x - slope * at.x, 0.0);
                let far = max(source.z + slope * (depth - at.z), 0.0);
                let passes = transfer_exp(depth);
                let share = (1.0 - passes) / depth - passes;
                let front = transfer_exp(before);
                piece.sum.light[k] += front * (near * (1.0 - passes - share) + far * share);
                rough[k] += front * (abs(source.y - source.x - slope * (at.y - at.x)) + 0.25 * abs(source.x - near));
            } else {
                let seen = j * Real3(transfer_exp(before + at.x), transfer_exp(before + at.y), transfer_exp(before + at.z));
                piece.sum.light[k] += dot(GAUSS_WEIGHTS, seen);
                nulls[k] += Real4(dot(cubic, seen), dot(linear, seen), 0.0, 0.0);
            }
            nulls[k] += Real4(0.0, 0.0, dot(cubic, dims), dot(linear, dims));
            piece.sum.depth[k] = before + depth;
        }
        half += 1u;
        continuing {
            break if half == 2u;
        }
    }
    // Errors in units of those that are allowed.
    for (var k = 0u; k < CHANNELS; k++) {
        let off = null_error(nulls[k].x, nulls[k].y) + rough[k];
        piece.error = max(piece.error, off / (piece.sum.light[k] + Real(transfer.floor)));
        if ABSORBS_VOLUMES {
            let shown = transfer_exp(transferred.depth[k]) * null_error(nulls[k].z, nulls[k].w);
            piece.error = max(piece.error, shown / clamp(piece.sum.depth[k], 1e-30, 1.0));
        }
    }
    return piece;
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

// Adds the light of a step from its start to the fraction `until`. The loop is tested at its end, because software drivers run the rest of
// a loop's body once more after a test at its start.
fn transfer_step(step: Stretch, until: Real) {
    var a: Real = 0.0;
    var size = until;
    var place = region_place(step, 0.0);
    let shortest = LEAST_PIECE * LAST_PART * until;
    var pieces = 0u;
    loop {
        pieces += 1u;
        let is_last = pieces > TRANSFER_PIECES || is_spent();
        let rest = until - a;
        var end = select(a + size, until, size > 0.9999 * rest || is_last);
        var at = region_place(step, end);
        let cut = region_cut(step, place, at, a, end);
        if cut.until < end {
            end = cut.until;
            at = region_behind(step, cut);
        }
        let own = end - a;
        let least = own <= shortest || is_last;
        let longest = max(transfer_longest(step, cut.within, a), shortest);
        var shortens = cut.unclear && !least;
        var error: Real = 0.0;
        if cut.within != 0u && !shortens && transfer_lasts() {
            let piece = transfer_piece(step, cut.within, a, own);
            error = piece.error;
            let agrees = error <= Real(transfer.tolerance) && own <= 1.001 * longest;
            shortens = !agrees && !least;
            transfer_unsettled = transfer_unsettled || (!agrees && is_last);
            if !shortens {
                transferred = piece.sum;
            }
        }
        let easy = select(Real(1.0), Real(2.0), 16.0 * error < Real(transfer.tolerance));
        let onward = select(max(size, easy * own), until, cut.within == 0u);
        size = select(onward, min(0.5 * own, longest), shortens);
        if !shortens {
            a = end;
            place = at;
        }
        continuing {
            break if a >= until;
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
    let height = spot.r - transfer.horizon;
    let slope = stretch_fall(step, until);
    if within == 0u || !(height > 0.0) || !(slope > 0.0) {
        return;
    }
    let here = matter_of(spot, within);
    spot.higher = 0.7071067811865476;
    let above = matter_of(spot, within);
    for (var k = 0u; k < CHANNELS; k++) {
        let passes = transfer_exp(transferred.depth[k]);
        transferred.light[k] += passes * tail_sum(here.emission[k], above.emission[k], height / slope);
        transferred.depth[k] += tail_sum(here.absorption[k], above.absorption[k], height / slope);
    }
}

// The lowest power of the height that has a sum.
const TAIL_POWER: Real = -0.95;

// Returns the sum to the horizon of a quantity, from its values here and at twice the height; `size` is the distance at the rate here.
fn tail_sum(here: Real, above: Real, size: Real) -> Real {
    if here <= 0.0 || above <= 0.0 {
        return 0.0;
    }
    let power = log_ratio(above, here) / 0.6931471805599453;
    transfer_invalid = transfer_invalid || power < TAIL_POWER;
    return here * size / (1.0 + max(power, TAIL_POWER));
}
