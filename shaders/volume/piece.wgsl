// A piece of a path: the light that its matter adds, its optical depth, and their errors. Each half of a piece has three Gauss points; where
// it is opaque, its source function j/κ is linear in the optical depth instead, which is exact for matter of one temperature however
// opaque it is. Sums of the same points, which vanish for cubic and for linear functions, estimate the error.

// The matter of half a piece.
struct HalfPiece {
    j: Real3,
    // The optical depth of all of it, and from its start to each point.
    depth: Real,
    at: Real3,
    // The source function at its start and its end if it is opaque, and the error of that.
    near: Real,
    far: Real,
    rough: Real,
}

// The light that a piece adds, as the camera sees it, and its depth; their errors, and the largest of these in units of those that count.
struct TransferPiece {
    added: Light,
    errors: array<Real2, CHANNELS>,
    error: Real,
}

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
// The optical depth of half a piece from which its source function is taken as linear.
const THICK: Real = 1.0;

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

// The part of a piece beyond its first and its last point.
const BEYOND_POINTS: Real = 0.0563508327;

// The value at an end by the three points of its half, from the next to the farthest.
const END_BY_POINTS: Real3 = Real3(1.478830557701236, -0.6666666666666667, 0.1878361089654305);

// Returns the errors of a piece by edges and kinks of matter between its ends and the points next to them: by the difference between the
// matter at each end and that of the parabola through the points of its half, `by_points`.
fn edge_error(k: u32, added: Light, size: Real, by_points: array<Matter, 2>) -> Real2 {
    let depth = transferred.depth[k];
    let m = channel_matter(k);
    let first = transfer_exp(depth) * edge_of(matter_before, by_points[0], m);
    let last = transfer_exp(depth + added.depth[k]) * edge_of(matter_behind, by_points[1], m);
    return BEYOND_POINTS * size * (first + last) * Real2(channel_emission(k), channel_absorption(k));
}

fn edge_of(end: Matter, by_points: Matter, m: u32) -> Real2 {
    return abs(Real2(end.emission[m] - by_points.emission[m], end.absorption[m] - by_points.absorption[m]));
}

// Returns the matter at an end by the points of its half, from the next to the farthest.
fn matter_by_points(next: Matter, middle: Matter, far: Matter) -> Matter {
    var end: Matter;
    for (var m = 0u; m < MATTERS; m++) {
        end.emission[m] = dot(END_BY_POINTS, Real3(next.emission[m], middle.emission[m], far.emission[m]));
        end.absorption[m] = dot(END_BY_POINTS, Real3(next.absorption[m], middle.absorption[m], far.absorption[m]));
    }
    return end;
}

// Returns half a piece by its emission and absorption at the points, times its size.
fn half_of(j: Real3, dims: Real3) -> HalfPiece {
    let depth = dot(GAUSS_WEIGHTS, dims);
    let at = max(Real3(dot(GAUSS_TO_FIRST, dims), dot(GAUSS_TO_MIDDLE, dims), dot(GAUSS_TO_LAST, dims)), Real3(0.0));
    let source = j / max(dims, Real3(1e-30));
    let slope = (source.z - source.x) / max(at.z - at.x, 1e-30);
    let near = max(source.x - slope * at.x, 0.0);
    let far = max(source.z + slope * (depth - at.z), 0.0);
    let rough = abs(source.y - source.x - slope * (at.y - at.x)) + 0.25 * abs(source.x - near);
    return HalfPiece(j, depth, at, near, far, rough);
}

// The matter at the start of a piece and at its end, at which the next piece starts.
var<private> matter_before: Matter;
var<private> matter_behind: Matter;

// Begins with the pieces of a part of a step.
fn begin_pieces(step: Stretch, within: u32, start: Real) {
    if BOUNDS_MATTER {
        begin_seen();
    }
    see_piece_end(step, within, start);
    start_next_piece();
}

fn start_next_piece() {
    if HAS_EDGES {
        matter_before = matter_behind;
    }
    if BOUNDS_MATTER {
        seen_before = seen_behind;
    }
}

fn see_piece_end(step: Stretch, within: u32, end: Real) {
    if HAS_EDGES {
        matter_behind = matter_at(step, within, end);
    } else if BOUNDS_MATTER {
        see_end(step, within, end);
    }
    if BOUNDS_MATTER {
        seen_behind = seen;
    }
}

// Returns a piece of a step between two fractions of it. `within` marks the volumes that contain it.
fn transfer_piece(step: Stretch, within: u32, start: Real, size: Real) -> TransferPiece {
    var piece: TransferPiece;
    // Sums that vanish for smooth functions, of the light and of the depth.
    var nulls: array<Real3, CHANNELS>;
    var depth_nulls: array<Real3, MATTERS>;
    var rough: array<Real, CHANNELS>;
    // The light that passes the matter before a half.
    var passing: array<Real, CHANNELS>;
    if ABSORBS {
        for (var k = 0u; k < CHANNELS; k++) {
            passing[k] = transfer_exp(transferred.depth[k]);
        }
    }
    let h = 0.5 * size;
    var by_points: array<Matter, 2>;
    if BOUNDS_MATTER {
        begin_seen();
    }
    see_piece_end(step, within, start + size);
    // The ends do not count as points at which matter is seen, because the sums do not contain them.
    if BOUNDS_MATTER {
        begin_points();
    }
    var half = 0u;
    loop {
        let a = start + Real(half) * h;
        let first = matter_at(step, within, a + GAUSS_POINTS.x * h);
        let middle = matter_at(step, within, a + GAUSS_POINTS.y * h);
        let last = matter_at(step, within, a + GAUSS_POINTS.z * h);
        if HAS_EDGES {
            if half == 0u {
                by_points[0] = matter_by_points(first, middle, last);
            } else {
                by_points[1] = matter_by_points(last, middle, first);
            }
        }
        let quartic = select(NULL_QUARTIC, -NULL_QUARTIC.zyx, half == 1u);
        let cubic = select(NULL_CUBIC, NULL_CUBIC.zyx, half == 1u);
        let linear = select(NULL_LINEAR, NULL_LINEAR.zyx, half == 1u);
        var halves: array<HalfPiece, MATTERS>;
        for (var m = 0u; m < MATTERS; m++) {
            let j = h * Real3(first.emission[m], middle.emission[m], last.emission[m]);
            let dims = h * Real3(first.absorption[m], middle.absorption[m], last.absorption[m]);
            halves[m] = half_of(j, dims);
            depth_nulls[m] += Real3(dot(quartic, dims), dot(cubic, dims), dot(linear, dims));
        }
        for (var k = 0u; k < CHANNELS; k++) {
            let own = halves[channel_matter(k)];
            let j = channel_emission(k) * own.j;
            if !ABSORBS {
                piece.added.light[k] += dot(GAUSS_WEIGHTS, j);
                nulls[k] += Real3(dot(quartic, j), dot(cubic, j), dot(linear, j));
                continue;
            }
            let depth = channel_absorption(k) * own.depth;
            piece.added.depth[k] += depth;
            if !EMITS {
                continue;
            }
            let passes = transfer_exp(depth);
            let front = passing[k];
            if depth > THICK {
                let share = (1.0 - passes) / depth - passes;
                let seen = front * channel_emission(k) / channel_absorption(k);
                piece.added.light[k] += seen * (own.near * (1.0 - passes - share) + own.far * share);
                rough[k] += seen * own.rough;
            } else {
                let at = channel_absorption(k) * own.at;
                let seen = front * j * Real3(real_exp(-at.x), real_exp(-at.y), real_exp(-at.z));
                piece.added.light[k] += dot(GAUSS_WEIGHTS, seen);
                nulls[k] += Real3(dot(quartic, seen), dot(cubic, seen), dot(linear, seen));
            }
            passing[k] = front * passes;
        }
        half += 1u;
        continuing {
            break if half == 2u;
        }
    }
    for (var k = 0u; k < CHANNELS; k++) {
        piece.errors[k].x = null_error(nulls[k]) + rough[k];
        if ABSORBS {
            piece.errors[k].y = depth_weight(k) * channel_absorption(k) * null_error(depth_nulls[channel_matter(k)]);
        }
        if HAS_EDGES {
            piece.errors[k] += edge_error(k, piece.added, size, by_points);
        }
        let relative = piece.errors[k] / light_that_counts(k, piece.added);
        piece.error = max(piece.error, max(relative.x, relative.y));
    }
    return piece;
}
