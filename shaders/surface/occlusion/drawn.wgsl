// Ambient occlusion (thesis 6.2): of ambient light as much reaches a place as its hemisphere is open, weighted by the cosine. One way
// a sample, in a direction that is drawn like matte light's.

struct Ambient {
    // How far is looked.
    distance: Real,
    // What is left where all is closed.
    floor: f32,
    // As lights have it.
    shadows: u32,
}

@group(0) @binding(148) var<uniform> ambient: Ambient;

// Random points' number of this use; others are numbers of segments.
const OCCLUSION: u32 = 0x80000000u;

var<private> shaded_pixel: vec2u;

fn note_pixel(pixel: vec2u) {
    shaded_pixel = pixel;
}

fn open_part(lit: Lit) -> Share {
    let u = lobe_point(shaded_pixel, OCCLUSION);
    let open = open_share(lit, way_about(lit.normal, sqrt(1.0 - u.x), sqrt(u.x), u.y));
    return ambient.floor + (1.0 - ambient.floor) * open;
}
