// What a path carries from surface to surface, in place of a weight alone: what light at its end counts for at the camera, and the light
// that it has found on its way. Since L/n² is kept along a ray (thesis Eq. 14), of all indices only the first and the last matter.

struct Carried {
    // The parts that surfaces have sent on.
    weight: vec3f,
    // n² where the camera is.
    camera: f32,
    // Light found so far, as the camera sees it.
    gathered: vec3f,
    // What emission that is met next counts for beside that which is aimed at (Veach 1997, the balance heuristic).
    share: f32,
    // Surfaces that sent it on so far.
    scatterings: u32,
    // Which of its rays is under way.
    flight: u32,
    // 1 once its first surface is in the picture's layers.
    recorded: u32,
    // 1 from where its wavelength has mattered.
    dispersed: u32,
}

var<storage, read_write> pixel_path: array<Carried>;

var<private> carried: Carried;

// The path's own ray.
const OWN: u32 = 0u;
// None: it ended on a surface, or by roulette.
const OVER: u32 = 1u;

fn load_weight(pixel: vec2u) {
    if DRAWS_WAVELENGTH {
        draw_wavelength(pixel);
    }
    carried = pixel_path[place_in_tile(pixel)];
}

fn store_weight(pixel: vec2u) {
    pixel_path[place_in_tile(pixel)] = carried;
}

fn start_weight(x: Real3) {
    carried = Carried(vec3f(1.0), 1.0, vec3f(0.0), 1.0, 0u, OWN, 0u, 0u);
    let n = medium_index(x);
    carried.camera = f32(n * n);
}

// Is next to nothing left?
fn scale_weight(factor: vec3f) -> bool {
    carried.weight *= factor;
    return max(carried.weight.x, max(carried.weight.y, carried.weight.z)) < DARK;
}

// Of light that is emitted at x towards the path.
fn gather(radiance: vec3f, x: Real3) {
    let n = medium_index(x);
    var light = carried.share * carried.camera / f32(n * n) * carried.weight * radiance;
    if COLORS_DISPERSED {
        color_dispersed(&light);
    }
    carried.gathered += light;
}
