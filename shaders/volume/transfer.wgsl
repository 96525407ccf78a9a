// Radiative transfer: the light that matter emits and absorbs along a path, in volumes and in media. I/ν³ is constant in vacuum, so that
// with s, the frequency to the matter divided by the frequency to the camera, and the affine parameter λ of light of frequency 1 at the
// camera,
//
//     I = ∫ j(sν)/s² e^(−T) dλ,    dT = s κ(sν) dλ.
//
// A step of the path is cut into pieces, by the error of the transfer and not by that of the path.

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

// j/s² and s κ, per unit of the step: of each channel, or of one to which all are proportional.
struct Matter {
    emission: array<Real, MATTERS>,
    absorption: array<Real, MATTERS>,
}

var<private> transferred: Light;
// True where matter cannot be as its formulas state: negative, not a number, or faster than light.
var<private> transfer_invalid: bool;
var<private> transfer_unsettled: bool;
// The largest error of a piece of the current step: that of `transfer`, or of a medium if that is smaller.
var<private> transfer_allowed: Real;
// The errors of the light and of the depth by pieces that could not be cut further.
var<private> transfer_doubts: array<Real2, CHANNELS>;

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

fn transfer_exp(depth: Real) -> Real {
    return real_exp(-min(depth, OPAQUE));
}

// Notes whether the light so far is less accurate than it should be.
fn note_doubts() {
    for (var k = 0u; k < CHANNELS; k++) {
        let allowed = transfer_allowed * light_that_counts(k, Light());
        transfer_unsettled = transfer_unsettled || any(transfer_doubts[k] > allowed);
        transfer_doubts[k] = Real2(0.0);
    }
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
    let extent = stretch_extent(step, until);
    let shortest = transfer_shortest(extent, until);
    transfer_allowed = Real(transfer.tolerance);
    if MEDIA_ABSORB {
        enter_medium();
        transfer_allowed = min(transfer_allowed, Real(absorption.tolerance));
    }
    if BOUNDS_MATTER {
        begin_bounds();
    }
    if HAS_VOLUMES {
        transfer_regions(step, until, extent, shortest);
    } else {
        transfer_part(step, 0u, 0.0, until, Real2(shortest, longest_piece(0u, until, extent.x, shortest)));
    }
}

// Returns the size of the longest pieces: through samples on grids, and through textures.
fn longest_piece(within: u32, until: Real, extent: Real, shortest: Real) -> Real {
    var longest: Real = 1e30;
    if HAS_GRIDS {
        longest = volume_cells(within);
    }
    if MEDIA_ABSORB {
        longest = min(longest, Real(absorption.piece));
    }
    return max(min(until, until * longest / max(extent, 1e-30)), shortest);
}

// Adds the light of a step through volumes and between them.
fn transfer_regions(step: Stretch, until: Real, extent: Real2, shortest: Real) {
    var a: Real = 0.0;
    var size = until;
    var place = region_place(step, 0.0);
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
        if (MEDIA_ABSORB | (cut.within != 0u)) && !shortens && transfer_lasts() {
            transfer_part(step, cut.within, a, end, Real2(shortest, longest_piece(cut.within, until, extent.x, shortest)));
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
    begin_pieces(step, within, start);
    loop {
        let is_last = size > 0.9999 * (end - a) || is_spent();
        let own = select(size, end - a, is_last);
        let is_tired = pieces > TRANSFER_PIECES || is_spent();
        let piece = transfer_piece(step, within, a, own);
        let allowed = transfer_allowed * Real(exp2(f32(max(pieces, MANY_PIECES) - MANY_PIECES) / 32.0));
        var agrees = piece.error <= allowed;
        if BOUNDS_MATTER {
            agrees = agrees && !matter_hides(within, piece, own);
        }
        let is_final = agrees || own <= sizes.x || is_tired;
        if is_final {
            add_piece(piece);
            start_next_piece();
            if !agrees || pieces > MANY_PIECES {
                doubt_piece(piece, is_tired && !agrees);
            }
            a = select(a + own, end, is_last);
        }
        let easy = is_tired || (agrees && 16.0 * piece.error < allowed);
        pieces += select(0u, 1u, is_final && !easy);
        var shorter = 0.5 * own;
        if HAS_JUMPS {
            shorter = max(size_to_jump(step, a, own), 0.5 * sizes.x);
        }
        size = min(select(shorter, max(size, select(Real(1.0), 2.0, easy) * own), is_final), sizes.y);
        continuing {
            break if a >= end || !transfer_lasts();
        }
    }
}
