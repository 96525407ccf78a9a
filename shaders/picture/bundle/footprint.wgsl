// Averages images and patterns over the footprint of each sample: its share of the bundle of light of its pixel, wherever light has been bent
// on the way (after Igehy 1999, with neighboring rays instead of derivatives). If the bundle does not end where the sample does, the footprint
// is unknown, and images are not filtered.

// The sides of a pixel as seen at the ends of its rays, and the end that its rays share; 0 if the bundle is unknown.
struct Bundle {
    across: vec3f,
    down: vec3f,
    end: u32,
}

// The footprint of one sample along the pixel's two sides; zero if unknown.
var<private> footprint: array<vec3f, 2>;
// The bundle of the pixel.
var<private> own_bundle: Bundle;
// The position on a surface where the ray ended.
var<private> place_seen: vec3f;
var<private> pixel_seen: vec2u;

// Loads the bundle of a pixel, before the color of a ray's end is computed.
fn note_bundle(pixel: vec2u) {
    pixel_seen = pixel;
    own_bundle = Bundle();
    footprint = array<vec3f, 2>();
    if READS_BUNDLES {
        if !is_grid(pixel) && frame.branch == 0u {
            own_bundle = pixel_bundle(pixel);
        }
    }
}

// Sets the footprint of a sample with this end.
fn fit_footprint(end: u32) {
    footprint = array<vec3f, 2>();
    if own_bundle.end == end {
        let side = share_side(pixel_seen);
        footprint = array<vec3f, 2>(side * own_bundle.across, side * own_bundle.down);
    }
}

// Stores the position on a surface, and sets the footprint there.
fn note_place(object: u32, uv: vec2f) {
    place_seen = vec3f(uv, 0.0);
    fit_footprint(surface_end(pixel_seen, object + 1u));
}

// Sets the footprint in an image on the surface that is repeated `repeat` times, before the image is sampled.
fn span_pattern(repeat: vec2f) {
    if FILTERS_IMAGES {
        note_spans(repeat * footprint[0].xy, repeat * footprint[1].xy);
    }
}
