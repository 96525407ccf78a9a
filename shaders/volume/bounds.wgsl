// The light that a piece of a path may hide, of matter too thin to meet its points. The values at the points give the ranges of the smooth
// functions in the formulas of emission and absorption, and these ranges bound both.

struct MatterSeen {
    // The least and the greatest values of the smooth functions.
    low: array<Real, SMOOTH_FUNCTIONS>,
    high: array<Real, SMOOTH_FUNCTIONS>,
    // The range of the frequency to the matter.
    frequency: Real2,
    // The largest emission and absorption of each coefficient.
    most: array<Real2, COEFFICIENTS>,
}

// The points of the current piece.
var<private> seen: array<MatterSeen, VOLUMES>;
// The largest emission and absorption of the current step so far.
var<private> step_most: array<Real2, VOLUMES>;

// A piece is cut if it may hide more than this factor of the matter at its points.
const HIDDEN_FACTOR: Real = 16.0;
// Hidden matter counts above this part of the step's largest, and above the least number.
const HIDDEN_PART: Real = 1e-8;
const HIDDEN_LEAST: Real = 1e-30;
// Ranges extend beyond the outermost points by this part.
const SEEN_MARGIN: Real = 0.15;

fn begin_bounds() {
    for (var v = 0u; v < VOLUMES; v++) {
        step_most[v] = Real2(0.0);
    }
}

fn begin_seen() {
    for (var v = 0u; v < VOLUMES; v++) {
        for (var i = 0u; i < SMOOTH_FUNCTIONS; i++) {
            seen[v].low[i] = 1e30;
            seen[v].high[i] = -1e30;
        }
        seen[v].frequency = Real2(UNBOUNDED, 0.0);
        for (var c = 0u; c < COEFFICIENTS; c++) {
            seen[v].most[c] = Real2(0.0);
        }
    }
}

fn see_value(v: u32, i: u32, value: Real) {
    seen[v].low[i] = min(seen[v].low[i], value);
    seen[v].high[i] = max(seen[v].high[i], value);
}

fn see_frequency(v: u32, nu: Real) {
    seen[v].frequency = Real2(min(seen[v].frequency.x, nu), max(seen[v].frequency.y, nu));
}

fn see_matter(v: u32, c: u32, matter: Real2) {
    seen[v].most[c] = max(seen[v].most[c], matter);
    step_most[v] = max(step_most[v], matter);
}

// Returns the range of a smooth function along the piece.
fn seen_range(v: u32, i: u32) -> Real2 {
    let margin = SEEN_MARGIN * (seen[v].high[i] - seen[v].low[i]);
    return interval_bounded(Real2(seen[v].low[i] - margin, seen[v].high[i] + margin));
}

// Returns the range of the frequency to the matter, which is unknown if there is none at the points.
fn seen_frequencies(v: u32) -> Real2 {
    let nu = seen[v].frequency;
    let margin = SEEN_MARGIN * (nu.y - nu.x);
    return select(Real2(max(nu.x - margin, 0.5 * nu.x), nu.y + margin), Real2(1e-9, 1e9), nu.x > nu.y);
}

// Returns `true` if a piece may hide light of a channel, of whose coefficient `most` is the largest possible emission and absorption.
fn hides_light(v: u32, c: u32, k: u32, most: Real2, piece: TransferPiece, size: Real) -> bool {
    let at = seen[v].most[c];
    let allowed = Real(transfer.tolerance) * light_that_counts(k, piece);
    let added = Real2(piece.added.light[k], transfer_exp(transferred.depth[k]) * piece.added.depth[k]);
    let counts = (at < 1e-20 * most) | (added * most > allowed * at);
    let is_seen = size * most <= HIDDEN_PART * step_most[v] + Real2(HIDDEN_LEAST);
    return any(counts & (most > HIDDEN_FACTOR * at) & !is_seen);
}
