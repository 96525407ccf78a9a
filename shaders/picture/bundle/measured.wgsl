// Measures the bundle of light of each pixel by differences between the ends of neighboring rays: central, or at an edge to one side.

// The largest difference between the ends of neighbors in one smooth bundle of light.
const WIDEST_BUNDLE: f32 = 0.5;

// The change of the end per pixel along one axis of the grid: the differences to the rays 2 and 1 before and 1 and 2 after, with weights.
struct GridSlope {
    change: Real3,
    // All are 0 if the change is unknown.
    weights: vec4f,
    // The neighbors belong to one smooth bundle. Farther ones, as close to the shadow of a black hole, only show how much of the sky the pixel
    // sees.
    is_smooth: bool,
}

struct MeasuredBundle {
    own: GridRay,
    across: GridSlope,
    down: GridSlope,
}

// Returns the difference of two ends; u and v may have wrapped around.
fn apart(a: GridRay, b: GridRay) -> Real3 {
    let d = b.place - a.place;
    let turns = select(vec3f(0.0), round(vec3f(d)), (a.end & END_KIND) == HIT);
    return d - Real3(turns);
}

fn is_near(a: GridRay, b: GridRay, d: Real3) -> bool {
    let near = vec3f(d);
    return a.end == b.end && dot(near, near) < WIDEST_BUNDLE * WIDEST_BUNDLE;
}

// stride: the number of rays from one to the next along the axis.
fn grid_slope(place: u32, stride: u32) -> GridSlope {
    let own = grid_rays[place];
    let before = grid_rays[place - stride];
    let after = grid_rays[place + stride];
    let d = apart(own, before);
    let e = apart(own, after);
    let near_before = is_near(before, own, d);
    let near_after = is_near(own, after, e);
    let is_smooth = near_before || near_after;
    let has_before = before.end == own.end && (near_before || !is_smooth);
    let has_after = after.end == own.end && (near_after || !is_smooth);
    let first = select(0.0, 1.0, has_before);
    let last = select(0.0, 1.0, has_after);
    let each = 1.0 / max(first + last, 1.0);
    let change = select(Real3(0.0), e * Real(each), has_after) - select(Real3(0.0), d * Real(each), has_before);
    return GridSlope(change, vec4f(0.0, -first * each, last * each, 0.0), is_smooth);
}

// Returns a slope whose error is of the fourth order of the size of a pixel, if five rays belong to one smooth bundle.
fn finer_slope(place: u32, stride: u32, slope: GridSlope) -> GridSlope {
    let own = grid_rays[place];
    let before = grid_rays[place - stride];
    let after = grid_rays[place + stride];
    let first = grid_rays[place - 2u * stride];
    let last = grid_rays[place + 2u * stride];
    let is_even = is_near(before, own, apart(before, own)) && is_near(own, after, apart(own, after))
        && is_near(first, before, apart(first, before)) && is_near(after, last, apart(after, last));
    let change = (Real(8.0) * (apart(own, after) - apart(own, before)) - (apart(own, last) - apart(own, first))) / Real(12.0);
    if is_even {
        return GridSlope(change, vec4f(1.0, -8.0, 8.0, -1.0) / 12.0, true);
    }
    return slope;
}

fn measured_bundle(pixel: vec2u) -> MeasuredBundle {
    let place = place_in_tile(pixel);
    return MeasuredBundle(grid_rays[place], grid_slope(place, 1u), grid_slope(place, frame.size.x));
}

// Returns the bundle in the axes of the scene.
fn bundle_of(measured: MeasuredBundle) -> Bundle {
    let is_known = any(measured.across.weights != vec4f(0.0)) && any(measured.down.weights != vec4f(0.0));
    var bundle = Bundle(vec3f(measured.across.change), vec3f(measured.down.change), select(0u, measured.own.end, is_known));
    if HAS_STARS {
        if (bundle.end & END_KIND) == ESCAPED {
            let side = side_of(bundle.end);
            bundle.across = from_star_axes(bundle.across, side);
            bundle.down = from_star_axes(bundle.down, side);
        }
    }
    return bundle;
}

// Adds the light of the sky in a pixel of the first sample, which is the grid.
fn add_sky(pixel: vec2u, measured: MeasuredBundle) {
    let end = measured.own.end;
    if (end & END_KIND) != ESCAPED {
        return;
    }
    own_bundle = bundle_of(measured);
    fit_footprint(end);
    if HAS_TWO_SKIES {
        is_beyond = side_of(end) == 1u;
    }
    var d = vec3f(measured.own.place);
    if HAS_STARS {
        d = from_star_axes(d, side_of(end));
    }
    var color = sky_radiance(d);
    if BEAMS {
        seen_shift = Real(measured.own.shift);
        color = beamed(color);
    }
    pixel_color[place_in_tile(pixel)] += measured.own.weight * color;
}
