// Chooses the pixels that take more samples, after each round. If the four corners of a pixel, shared with its neighbors, have the same end
// and similar colors, the pixel is done with their mean. Other pixels take FIRST_SAMPLES more, and then twice as many until the
// standard error of their mean is below the tolerance, or until they reach the limit, which is counted.

struct Refinement {
    // The tolerance of displayed values, from 0 to 1.
    tolerance: f32,
    // The largest number of samples of a pixel.
    most: u32,
    // The factor from linear to displayed values.
    gain: f32,
}

var<uniform> refinement: Refinement;

// Counts for the host.
struct Refined {
    open: atomic<u32>,
    capped: atomic<u32>,
}

var<storage, read_write> refined: Refined;

const FIRST_SAMPLES: u32 = 16u;

var<workgroup> group_open: atomic<u32>;
var<workgroup> group_capped: atomic<u32>;

// Decides by the four corners: done, or open. Their displayed values are compared, and their mean is linear.
fn from_corners(pixel: vec2u) -> Moments {
    let end = load_corner(pixel);
    var alike = corners_shared(frame.origin + pixel);
    var sum = vec4f(0.0);
    var low = vec4f(1.0);
    var high = vec4f(0.0);
    for (var i = 0u; i < 4u; i++) {
        let corner = pixel + vec2u(i & 1u, i >> 1u);
        let c = load_color(corner);
        let covered = load_coverage(corner);
        let shown = vec4f(displayed(c), covered);
        sum += vec4f(c, covered);
        low = min(low, shown);
        high = max(high, shown);
        alike = alike && load_corner(corner) == end;
    }
    if alike && all(high - low <= vec4f(refinement.tolerance)) {
        return Moments(0.25 * sum.xyz + own_starlight(pixel), 0.25 * sum.w, vec3f(0.0), 1u);
    }
    return Moments(vec3f(0.0), 0.0, vec3f(0.0), 1u | OPEN);
}

// Returns the moments with one more sample, the n-th of the pixel.
fn with_sample(before: Moments, pixel: vec2u, n: f32) -> Moments {
    let c = load_color(pixel);
    let sum = before.color + c;
    let off = c - before.color / max(n - 1.0, 1.0);
    let squares = before.squares + select(vec3f(0.0), off * (c - sum / n), n > 1.0);
    return Moments(sum, before.alpha + load_coverage(pixel), squares, before.state + 1u);
}

// Returns the standard error of the mean of n samples as it is displayed, the largest over the channels.
fn shown_error(m: Moments, n: f32) -> f32 {
    let mean = m.color / n;
    let error = sqrt(m.squares / (n * (n - 1.0)));
    let apart = 0.5 * (displayed(mean + error) - displayed(mean - error));
    let covered = m.alpha / n;
    return max(max(apart.x, apart.y), max(apart.z, sqrt(max(covered * (1.0 - covered), 0.0) / n)));
}

// Returns the light of stars, which has no error to estimate.
fn own_starlight(pixel: vec2u) -> vec3f {
    if ADDS_STARLIGHT {
        return pixel_starlight[place_in_tile(pixel)];
    }
    return vec3f(0.0);
}

fn closed(m: Moments, pixel: vec2u, n: f32, flag: u32) -> Moments {
    return Moments(m.color / n + own_starlight(pixel), m.alpha / n, m.squares, (m.state & RAYS) | flag);
}

// Decides after the last sample of a doubling.
fn judged(m: Moments, pixel: vec2u, n: u32) -> Moments {
    if shown_error(m, f32(n)) < refinement.tolerance {
        return closed(m, pixel, f32(n), 0u);
    }
    if n >= refinement.most {
        return closed(m, pixel, f32(n), CAPPED);
    }
    return m;
}

// Returns `true` if a pixel belongs to the tile: the last column and row exist only for their corners, and a grid has a wider margin.
fn inside_corners(pixel: vec2u) -> bool {
    if HAS_GRID {
        return inside_margin(pixel);
    }
    return all(pixel + 1u < frame.size);
}

@compute @workgroup_size(GROUP)
fn refine(own: Invocation) {
    let spot = round_pixel(own);
    let n = sample_of(spot.pixel);
    let judges = n == 0u || (n >= FIRST_SAMPLES && countOneBits(n) == 1u);
    var state = 0u;
    if spot.valid && inside_corners(spot.pixel) && sample_wanted(spot.pixel) {
        let i = place_in_tile(spot.pixel);
        var m: Moments;
        if n == 0u {
            m = from_corners(spot.pixel);
        } else {
            m = with_sample(moments[i], spot.pixel, f32(n));
            if judges {
                m = judged(m, spot.pixel, n);
            }
        }
        moments[i] = m;
        state = m.state;
    }
    let open = judges && (state & OPEN) != 0u;
    if open {
        atomicAdd(&group_open, 1u);
    }
    if judges && (state & CAPPED) != 0u {
        atomicAdd(&group_capped, 1u);
    }
    workgroupBarrier();
    if own.lane == 0u {
        atomicAdd(&refined.open, atomicLoad(&group_open));
        atomicAdd(&refined.capped, atomicLoad(&group_capped));
    }
    keep_active(open, spot.pixel, own.lane);
}
