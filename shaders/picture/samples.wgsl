// Gives every pixel every sample, and measures footprints. If images and patterns are averaged, rays through the corners of all pixels are
// followed before the first sample. The footprint is the distance between the four ends of a pixel's corners, wherever light has been bent
// on the way (after Igehy 1999, with neighbors instead of derivatives). If the corners do not have the same end, the footprint is unknown,
// and images are not filtered.

struct Corner {
    // u and v on a surface, or the direction at infinity.
    place: vec3f,
    // The status and the object of the ray's end.
    end: u32,
}

var<storage, read_write> pixel_corner: array<Corner>;

// The sides of a pixel as seen at the ends of its rays, and the end that its corners share; 0 if they do not share one.
struct Bundle {
    across: vec3f,
    down: vec3f,
    end: u32,
}

// The largest difference of directions within one smooth bundle of light.
const WIDEST_BUNDLE: f32 = 0.5;

// The footprint of one sample along the pixel's two sides; zero if unknown.
var<private> footprint: array<vec3f, 2>;
// The surface to which the footprint belongs.
var<private> footprint_end: u32;
// The position on a surface where the ray ended.
var<private> place_seen: vec3f;

// Sums run over all samples of a pixel: the host divides once, at the end.
fn sum_begins() -> bool {
    return frame.sample + frame.branch == 0u;
}

// The last column and row exist only for their corners.
fn sample_wanted(pixel: vec2u) -> bool {
    if HAS_STARS {
        return frame.sample >= CORNERS || IS_ONE_SAMPLE || inside_margin(pixel);
    }
    if !KEEPS_FOOTPRINTS {
        return true;
    }
    return frame.sample == CORNERS || all(pixel + 1u < frame.size);
}

fn end_of(status: u32, object: u32) -> u32 {
    return select(status, ESCAPED, status == MISSED) | (object << 4u);
}

// Returns the difference of two corners; u and v may have wrapped around.
fn apart(a: Corner, b: Corner) -> vec3f {
    let d = b.place - a.place;
    return select(d, d - round(d), (a.end & 15u) == HIT);
}

// Prepares the footprint, before the color of a ray's end is computed.
fn note_footprint(pixel: vec2u, ray: Ray) {
    footprint = array<vec3f, 2>();
    footprint_end = end_of(ray.status, 0u);
    if frame.sample == CORNERS || frame.branch != 0u {
        return;
    }
    let bundle = pixel_bundle(pixel);
    if (bundle.end & 15u) == (footprint_end & 15u) {
        footprint_end = bundle.end;
        footprint = array<vec3f, 2>(sample_share.side * bundle.across, sample_share.side * bundle.down);
    }
}

// Stores the position on a surface.
fn note_place(object: u32, uv: vec2f) {
    place_seen = vec3f(uv, 0.0);
    if end_of(HIT, object + 1u) != footprint_end {
        footprint = array<vec3f, 2>();
    }
}

// Sets the footprint in an image on the surface that is repeated `repeat` times, before the image is sampled.
fn span_pattern(repeat: vec2f) {
    if FILTERS_IMAGES {
        note_spans(repeat * footprint[0].xy, repeat * footprint[1].xy);
    }
}

fn keep_corner(pixel: vec2u, ray: Ray, seen: Seen) {
    if !KEEPS_FOOTPRINTS {
        return;
    }
    if frame.sample == CORNERS && frame.branch == 0u {
        let place = select(vec3f(normalize(seen.end.v)), place_seen, ray.status == HIT);
        pixel_corner[place_in_tile(pixel)] = Corner(place, end_of(ray.status, seen.object));
    }
    // The footprint of the next pixel is unknown.
    footprint = array<vec3f, 2>();
}
