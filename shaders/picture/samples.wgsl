// Every pixel takes every sample. Before the first, where pictures and patterns are averaged, rays through the corners of all pixels tell what of a picture or a pattern a pixel sees:
// as large as the four ends of its corners are apart, wherever light has been bent on its way (after Igehy 1999, with neighbours in place
// of derivatives). Where corners do not end alike it is not known, and pictures are as sharp as ever.

struct Corner {
    // On a surface its u and v, at infinity the direction.
    place: vec3f,
    // How the ray ended, and on which object.
    end: u32,
}

var<storage, read_write> pixel_corner: array<Corner>;

// Directions further apart than this are not of one bundle of light, or of none that is smooth.
const WIDEST_BUNDLE: f32 = 0.5;

// What one sample sees along the pixel's two sides; zero where that is not known.
var<private> footprint: array<vec3f, 2>;
// The surface that it was known of.
var<private> footprint_end: u32;
// Where on a surface the ray ended.
var<private> place_seen: vec3f;

// Sums run over all of a pixel's samples: the host divides once, at the end.
fn sum_begins() -> bool {
    return frame.sample + frame.branch == 0u;
}

// The last column and row exist only for their corners.
fn sample_wanted(pixel: vec2u) -> bool {
    if !KEEPS_FOOTPRINTS {
        return true;
    }
    return frame.sample == CORNERS || all(pixel + 1u < frame.size);
}

fn end_of(status: u32, object: u32) -> u32 {
    return select(status, ESCAPED, status == MISSED) | (object << 4u);
}

// From one corner to another; u and v may have gone round.
fn apart(a: Corner, b: Corner) -> vec3f {
    let d = b.place - a.place;
    return select(d, d - round(d), (a.end & 15u) == HIT);
}

// Before what a ray saw is asked for.
fn note_footprint(pixel: vec2u, ray: Ray) {
    footprint = array<vec3f, 2>();
    footprint_end = end_of(ray.status, 0u);
    if frame.sample == CORNERS || frame.branch != 0u || !corners_shared(frame.origin + pixel) {
        return;
    }
    let a = pixel_corner[place_in_tile(pixel)];
    let b = pixel_corner[place_in_tile(pixel + vec2u(1u, 0u))];
    let c = pixel_corner[place_in_tile(pixel + vec2u(0u, 1u))];
    let d = pixel_corner[place_in_tile(pixel + vec2u(1u, 1u))];
    if any(vec3u(b.end, c.end, d.end) != vec3u(a.end)) || (a.end & 15u) != (footprint_end & 15u) {
        return;
    }
    footprint_end = a.end;
    let across = 0.5 * (apart(a, b) + apart(c, d));
    let down = 0.5 * (apart(a, c) + apart(b, d));
    if max(dot(across, across), dot(down, down)) < WIDEST_BUNDLE * WIDEST_BUNDLE {
        footprint = array<vec3f, 2>(sample_share.side * across, sample_share.side * down);
    }
}

// On a surface.
fn note_place(object: u32, uv: vec2f) {
    place_seen = vec3f(uv, 0.0);
    if end_of(HIT, object + 1u) != footprint_end {
        footprint = array<vec3f, 2>();
    }
}

// Before a picture on it is sampled, which is repeated so often.
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
    // On the next pixel's way nothing is known.
    footprint = array<vec3f, 2>();
}
