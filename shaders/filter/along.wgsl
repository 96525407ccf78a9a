// Filters (thesis 2.3, 4.4): what a medium leaves of light on its way, L = exp(−∫ σ ds) L₀, where s is length in the scene and
// σ = −ln c of the colour c that is left after a unit length. Weighed as a ray passes, step by step; the last step as far as it went.
//
// A step is cut into pieces, each by Gauss's two points and again by its halves, until the two agree; what is taken is better than
// both by Richardson's formula. Places on a curved step are retaken, as exact as the step itself.

struct Filter {
    // The density of an even filter, or the colour that is left where a texture is 0.
    color: vec3f,
    kind: u32,
    // The colour that is left where a texture is 1.
    high: vec3f,
    // How far the optical depths of a piece and of its halves may differ.
    tolerance: f32,
    // Where textures and formulas have their origin.
    center: Real3,
    // No piece is longer.
    piece: f32,
    // Radiance of the medium's own, per unit length.
    glow: vec3f,
    // Lattice cells a unit length.
    frequency: f32,
    axis: vec3f,
    octaves: u32,
    seed: u32,
    // Of a wrapped texture its turns, and of marble the noise's part.
    times: f32,
    // Which formulas, or which picture.
    which: u32,
}

var<storage, read> filters: array<Filter>;

// Half the distance between Gauss's two points, in parts of a piece.
const GAUSS: Real = 0.28867513459481287;
// Pieces that a step is cut into, at most.
const FILTER_PIECES: u32 = 1024u;
// Of what a whole step may err a piece may this part, however short it is.
const LEAST_SHARE: f32 = 0.25;
// What rounding makes of an optical depth.
const FILTER_ROUNDING: f32 = 4e-7;

// Of a piece, by the rule and by the rule for its halves.
struct Depths {
    whole: vec4f,
    halves: vec4f,
}

var<private> filter_slips: bool;

fn filter_step(ray: Ray, next: Ray) {
    if SEES_GLOW {
        note_glow();
    }
    filter_part(ray.phase, own_size(ray, next));
}

// The step on which a path ended, up to there.
fn filter_last(ray: Ray, end: PathPoint) {
    if SEES_GLOW {
        note_glow();
    }
    filter_end(ray, end);
}

fn filter_end(ray: Ray, end: PathPoint) {
    if end.fraction > 0.0 {
        let step = last_step(ray);
        filter_part(step.phase, end.fraction * step.h);
    }
}

// The same behind a surface, which has put the ray into another region and on a branch: it came through this region, as was noted.
fn filter_left(ray: Ray, end: PathPoint, came_through: u32) {
    let now = region_bits();
    enter_set(came_through);
    filter_end(ray, end);
    enter_set(now);
}

// A segment between two slots of the state, if its ray is under way behind it.
fn filter_passed(spot: ActiveRay, lives: bool) {
    if lives {
        load_weight(spot.pixel);
        let ray = load_ray(spot.pixel, spot.word);
        if FILTERS {
            filter_step(ray, accepted_step(ray));
        }
        store_weight(spot.pixel);
    }
}

// A place on a ray's path so far behind p, in the step's own measure, with the length that the path covers there for each unit of that.
fn path_place(p: Phase, h: Real) -> Real4 {
    let q = retaken_step(p, h);
    return Real4(q[0].xyz, path_pace(q));
}

fn path_pace(p: Phase) -> Real {
    return length(path_velocity(p[1].xyz)) * own_pace(p);
}

// A point of the texture, so far behind p.
fn place_in_filter(filter_at: Filter, p: Phase, h: Real) -> Real3 {
    return track_place(p, h).xyz - filter_at.center;
}

// The part of size h, in the step's own measure, that begins at p.
fn filter_part(p: Phase, h: Real) {
    let filter_at = filters[filter_place()];
    let speed = f32(track_pace(p));
    let longest = min(h, Real(filter_at.piece / max(speed, 1e-30)));
    var size = longest;
    var a: Real = 0.0;
    filter_slips = false;
    for (var k = 0u; k <= FILTER_PIECES && a < h; k++) {
        let rest = h - a;
        let is_last = k == FILTER_PIECES || is_spent();
        let own = select(min(size, rest), rest, is_last || size >= 0.999 * rest);
        let depths = depths_over(filter_at, p, a, own);
        let whole = depths.whole;
        let halves = depths.halves;
        let off = abs(halves.xyz - whole.xyz);
        let apart = max(off.x, max(off.y, off.z));
        let deep = max(halves.x, max(halves.y, halves.z));
        // Of what a step may err a piece may by its length, down to a part.
        let share = max(f32(own / h), LEAST_SHARE);
        let agrees = apart <= max(share * filter_at.tolerance, FILTER_ROUNDING * deep);
        filter_slips = filter_slips || (!agrees && is_last);
        if agrees || is_last {
            let depth = max(halves + (halves - whole) / 15.0, vec4f(0.0));
            take_piece(filter_at, track_place(p, a + 0.5 * own).xyz, depth);
            a += own;
            size = min(2.0 * size, longest);
        } else {
            size = smaller_piece(filter_at, p, a, own);
        }
    }
    if filter_slips {
        tally_at_once(UNFILTERED);
    }
}

// The optical depth of a piece from a on, and its length, by Gauss's rule: for all of it, and for its halves.
fn depths_over(filter_at: Filter, p: Phase, a: Real, size: Real) -> Depths {
    var depths = Depths(vec4f(0.0), vec4f(0.0));
    // In a loop, for a texture's density is long: two points of the whole, then two of either half.
    for (var i = 0u; i < 6u; i++) {
        let in_halves = i >= 2u;
        let middle = select(0.5, select(0.25, 0.75, i >= 4u), in_halves);
        let part = select(1.0, 0.5, in_halves);
        let side = select(-GAUSS, GAUSS, (i & 1u) == 1u);
        let rate = depth_rate(filter_at, track_place(p, a + (Real(middle) + Real(part) * side) * size));
        let depth = 0.5 * part * f32(size) * rate;
        depths.whole += select(depth, vec4f(0.0), in_halves);
        depths.halves += select(vec4f(0.0), depth, in_halves);
    }
    return depths;
}

fn depth_rate(filter_at: Filter, q: Real4) -> vec4f {
    let density = filter_density(filter_at, q.xyz - filter_at.center);
    let there = all(density >= vec3f(0.0));
    filter_slips = filter_slips || !there;
    return f32(q.w) * vec4f(select(vec3f(0.0), density, there), 1.0);
}

// Of the colour that is left after a unit length: none of what is 0.
fn density_of(color: vec3f) -> vec3f {
    return -log(max(color, vec3f(1e-30)));
}

// Each region has a filter of its own, and the space outside of all the last one.
fn filter_place() -> u32 {
    if !HAS_REGIONS {
        return 0u;
    }
    return min(medium_object(), REGION_COUNT);
}
