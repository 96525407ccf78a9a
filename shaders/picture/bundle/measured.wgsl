// Measures the bundle of light of each pixel by differences between the ends of neighboring rays: central, or at an edge to one side.

// The largest difference between the ends of neighbors in one smooth bundle of light.
const WIDEST_BUNDLE: f32 = 0.5;

// The change of the end per pixel along one axis of the grid, and the offsets of the two rays between which it is measured, in pixels.
struct GridSlope {
    change: vec3f,
    first: f32,
    last: f32,
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
fn apart(a: GridRay, b: GridRay) -> vec3f {
    let d = b.place - a.place;
    return select(d, d - round(d), (a.end & END_KIND) == HIT);
}

fn is_near(a: GridRay, b: GridRay, d: vec3f) -> bool {
    return a.end == b.end && dot(d, d) < WIDEST_BUNDLE * WIDEST_BUNDLE;
}

// stride: the number of rays from one to the next along the axis.
fn grid_slope(place: u32, stride: u32) -> GridSlope {
    let own = grid_rays[place];
    let before = grid_rays[place - stride];
    let after = grid_rays[place + stride];
    let d = apart(before, own);
    let e = apart(own, after);
    let is_smooth = is_near(before, own, d) || is_near(own, after, e);
    let has_before = before.end == own.end && (is_near(before, own, d) || !is_smooth);
    let has_after = after.end == own.end && (is_near(own, after, e) || !is_smooth);
    let change = select(vec3f(0.0), d, has_before) + select(vec3f(0.0), e, has_after);
    let first = -f32(has_before);
    let last = f32(has_after);
    return GridSlope(change / max(last - first, 1.0), first, last, is_smooth);
}

fn measured_bundle(pixel: vec2u) -> MeasuredBundle {
    let place = place_in_tile(pixel);
    return MeasuredBundle(grid_rays[place], grid_slope(place, 1u), grid_slope(place, frame.size.x));
}

// Returns the bundle in the axes of the scene.
fn bundle_of(measured: MeasuredBundle) -> Bundle {
    let is_known = measured.across.first < measured.across.last && measured.down.first < measured.down.last;
    var bundle = Bundle(measured.across.change, measured.down.change, select(0u, measured.own.end, is_known));
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
    var d = measured.own.place;
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
