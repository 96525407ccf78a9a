// Computes absorption in media (T 2.3, 4.4): the transmittance exp(−∫ σ ds), where s is length in the scene and σ = −ln c, c being the
// color that remains after a unit length. It is accumulated step by step as a ray passes; the last step counts up to its end.
//
// A step is cut into pieces. Each is integrated by the two-point Gauss rule and again in halves, until the two results agree; Richardson
// extrapolation then gives a value better than both. Positions on a curved step are retaken, so that they are as exact as the step itself.

struct Absorption {
    // The color after a unit length of a uniform absorber, or the color where a texture is 0.
    color: vec3f,
    kind: u32,
    // The color after a unit length where a texture is 1.
    high: vec3f,
    // The largest difference between the optical depths of a piece and of its halves.
    tolerance: f32,
    // The origin of textures and formulas.
    center: Real3,
    // The largest length of a piece.
    piece: f32,
    // The radiance that the medium emits, per unit length.
    emission: vec3f,
    // Lattice cells per unit length.
    frequency: f32,
    axis: vec3f,
    octaves: u32,
    seed: u32,
    // The number of turns of a wrapped texture, or the amplitude of the noise in marble.
    times: f32,
    // The index of the formulas or of the image.
    which: u32,
}

var<storage, read> absorptions: array<Absorption>;

// Half the distance between the two Gauss points, as a fraction of a piece.
const GAUSS: Real = 0.28867513459481287;
// The largest number of pieces of a step.
const FILTER_PIECES: u32 = 1024u;
// The least share of a step's tolerance that a piece may use, however short it is.
const LEAST_SHARE: f32 = 0.25;
// The effect of rounding on an optical depth.
const FILTER_ROUNDING: f32 = 4e-7;

// The optical depth of a piece, by the rule and by the rule for its halves.
struct Depths {
    whole: vec4f,
    halves: vec4f,
}

var<private> absorption_slips: bool;

fn absorption_step(ray: Ray, next: Ray) {
    if SEES_GLOW {
        note_glow();
    }
    absorption_part(ray.phase, own_size(ray, next));
}

// Adds the absorption of the step on which a path ended, up to its end.
fn absorption_last(ray: Ray, end: PathPoint) {
    if SEES_GLOW {
        note_glow();
    }
    absorption_end(ray, end);
}

fn absorption_end(ray: Ray, end: PathPoint) {
    if end.fraction > 0.0 {
        let step = last_step(ray);
        absorption_part(step.phase, end.fraction * step.h);
    }
}

// Adds the absorption of the last step, after a surface has put the ray into another region and on a branch; `came_through` is the region
// that the ray passed.
fn absorption_left(ray: Ray, end: PathPoint, came_through: u32) {
    let now = region_bits();
    enter_set(came_through);
    absorption_end(ray, end);
    enter_set(now);
}

// Adds the absorption of a segment between two slots of the state, if its ray continues after it.
fn absorption_passed(spot: ActiveRay, lives: bool) {
    if lives {
        load_throughput(spot.pixel);
        let ray = load_ray(spot.pixel, spot.word);
        if ABSORBS {
            absorption_step(ray, accepted_step(ray));
        }
        store_throughput(spot.pixel);
    }
}

// Returns the position on a ray's path at h behind p, in the parameter of the step, and the length that the path covers there per unit of
// h.
fn path_place(p: Phase, h: Real) -> Real4 {
    let q = retaken_step(p, h);
    return Real4(q[0].xyz, path_pace(q));
}

fn path_pace(p: Phase) -> Real {
    return length(path_velocity(p[1].xyz)) * own_pace(p);
}

// Returns the point of the texture at h behind p.
fn place_in_absorption(absorption: Absorption, p: Phase, h: Real) -> Real3 {
    return track_place(p, h).xyz - absorption.center;
}

// Adds the absorption of the stretch of size h, in the parameter of the step, that begins at p.
fn absorption_part(p: Phase, h: Real) {
    let absorption = absorptions[absorption_place()];
    let speed = f32(track_pace(p));
    let longest = min(h, Real(absorption.piece / max(speed, 1e-30)));
    var size = longest;
    var a: Real = 0.0;
    absorption_slips = false;
    for (var k = 0u; k <= FILTER_PIECES && a < h; k++) {
        let rest = h - a;
        let is_last = k == FILTER_PIECES || is_spent();
        let own = select(min(size, rest), rest, is_last || size >= 0.999 * rest);
        let depths = depths_over(absorption, p, a, own);
        let whole = depths.whole;
        let halves = depths.halves;
        let off = abs(halves.xyz - whole.xyz);
        let apart = max(off.x, max(off.y, off.z));
        let deep = max(halves.x, max(halves.y, halves.z));
        // A piece may use the share of a step's tolerance that its length has, down to a minimum.
        let share = max(f32(own / h), LEAST_SHARE);
        let agrees = apart <= max(share * absorption.tolerance, FILTER_ROUNDING * deep);
        absorption_slips = absorption_slips || (!agrees && is_last);
        if agrees || is_last {
            let depth = max(halves + (halves - whole) / 15.0, vec4f(0.0));
            take_piece(absorption, track_place(p, a + 0.5 * own).xyz, depth);
            a += own;
            size = min(2.0 * size, longest);
        } else {
            size = smaller_piece(absorption, p, a, own);
        }
    }
    if absorption_slips {
        tally_at_once(UNFILTERED);
    }
}

// Returns the optical depth of a piece that begins at a, and its length, by the Gauss rule: for the whole piece, and for its halves.
fn depths_over(absorption: Absorption, p: Phase, a: Real, size: Real) -> Depths {
    var depths = Depths(vec4f(0.0), vec4f(0.0));
    // A loop, because the code of a texture's density is long: two points of the whole, then two of either half.
    for (var i = 0u; i < 6u; i++) {
        let in_halves = i >= 2u;
        let middle = select(0.5, select(0.25, 0.75, i >= 4u), in_halves);
        let part = select(1.0, 0.5, in_halves);
        let side = select(-GAUSS, GAUSS, (i & 1u) == 1u);
        let rate = depth_rate(absorption, track_place(p, a + (Real(middle) + Real(part) * side) * size));
        let depth = 0.5 * part * f32(size) * rate;
        depths.whole += select(depth, vec4f(0.0), in_halves);
        depths.halves += select(vec4f(0.0), depth, in_halves);
    }
    return depths;
}

fn depth_rate(absorption: Absorption, q: Real4) -> vec4f {
    let density = absorption_density(absorption, q.xyz - absorption.center);
    let there = all(density >= vec3f(0.0));
    absorption_slips = absorption_slips || !there;
    return f32(q.w) * vec4f(select(vec3f(0.0), density, there), 1.0);
}

// Returns the absorption coefficient for the color that remains after a unit length; no infinity where the color is 0.
fn density_of(color: vec3f) -> vec3f {
    return -log(max(color, vec3f(1e-30)));
}

// Each region has its own absorption, and the space outside all regions has the last one.
fn absorption_place() -> u32 {
    if !HAS_REGIONS {
        return 0u;
    }
    return min(medium_object(), REGION_COUNT);
}
