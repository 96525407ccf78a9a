// The light that a piece may hide, of matter too thin to meet its points. The values at the points and at the ends give the ranges of the
// smooth functions in the formulas of emission and absorption, and these ranges bound both.

struct MatterSeen {
    // The number of points.
    points: u32,
    // The least and the greatest values of the smooth functions.
    low: array<Real, SMOOTH_FUNCTIONS>,
    high: array<Real, SMOOTH_FUNCTIONS>,
    // The range of s; 0 if there is no matter.
    shift: Real2,
    // The largest emission and absorption of each kind of light: of a frequency, or of a color.
    most: array<Real2, LIGHTS_SEEN>,
}

// The points of the current piece.
var<private> seen: array<MatterSeen, MATTER_SLOTS>;
// The largest emission and absorption of the current step so far.
var<private> step_most: array<Real2, MATTER_SLOTS>;

// A piece is cut if it may hide more than this factor of the matter at its points.
const HIDDEN_FACTOR: Real = 16.0;
// Hidden matter counts above this part of the step's largest, and above the least number.
const HIDDEN_PART: Real = 1e-8;
const HIDDEN_LEAST: Real = 1e-30;
// Ranges extend beyond the values by this part.
const SEEN_MARGIN: Real = 0.15;

fn begin_bounds() {
    step_most = array<Real2, MATTER_SLOTS>();
}

// Begins with no points.
fn begin_seen() {
    seen = array<MatterSeen, MATTER_SLOTS>();
}

// The start and the end of the current piece.
var<private> seen_before: array<MatterSeen, MATTER_SLOTS>;
var<private> seen_behind: array<MatterSeen, MATTER_SLOTS>;

// Adds the start of the piece to its end, and begins with the points of the sums: the largest matter is theirs.
fn begin_points() {
    for (var v = 0u; v < MATTER_SLOTS; v++) {
        if seen_before[v].points > 0u {
            for (var i = 0u; i < SMOOTH_FUNCTIONS; i++) {
                see_value(v, i, seen_before[v].low[i]);
            }
        }
        seen[v].most = array<Real2, LIGHTS_SEEN>();
    }
}

fn see_value(v: u32, i: u32, value: Real) {
    let is_first = seen[v].points == 0u;
    seen[v].low[i] = select(min(seen[v].low[i], value), value, is_first);
    seen[v].high[i] = select(max(seen[v].high[i], value), value, is_first);
}

// Ends the record of a point.
fn see_point(v: u32) {
    seen[v].points += 1u;
}

fn see_shift(v: u32, s: Real) {
    let before = seen[v].shift;
    seen[v].shift = Real2(select(min(before.x, s), s, before.y == 0.0), max(before.y, s));
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

// Returns the range of s along the piece, which is unknown if there is no matter at the points.
fn seen_shifts(v: u32) -> Real2 {
    let s = seen[v].shift;
    let margin = SEEN_MARGIN * (s.y - s.x);
    return select(Real2(max(s.x - margin, 0.5 * s.x), s.y + margin), Real2(1e-9, 1e9), s.y == 0.0);
}

// Returns `true` if a piece may hide light of a channel, whose largest possible emission and absorption is `most`; `c` is its kind of light.
fn hides_light(v: u32, c: u32, k: u32, most: Real2, piece: TransferPiece, size: Real) -> bool {
    let at = seen[v].most[c];
    let allowed = transfer_allowed * light_that_counts(k, piece.added);
    let added = Real2(piece.added.light[k], depth_weight(k) * piece.added.depth[k]);
    let counts = (at < 1e-20 * most) | (added * most > allowed * at);
    let is_seen = size * most <= HIDDEN_PART * step_most[v] + Real2(HIDDEN_LEAST);
    return any(counts & (most > HIDDEN_FACTOR * at) & !is_seen);
}
