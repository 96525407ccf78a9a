// The state that a path carries from surface to surface, instead of a throughput alone: the throughput, and the light that it has found.
// Since L/n² is constant along a ray (T Eq. 14), only the first and the last of all indices matter.

struct Carried {
    // The throughput: the product of the surfaces' reflected or transmitted fractions.
    throughput: vec3f,
    // n² at the camera.
    camera: f32,
    // The light found so far, as the camera sees it.
    gathered: vec3f,
    // The throughput of emission that is met next, when it is also sampled by next-event estimation (Veach 1997, the balance heuristic).
    share: f32,
    // The number of surfaces that scattered the path so far.
    scatterings: u32,
    // The ray of the path that is being followed.
    flight: u32,
    // 1 once its first surface is in the image's layers.
    recorded: u32,
    // 1 once its wavelength has mattered.
    dispersed: u32,
}

var<storage, read_write> pixel_path: array<Carried>;

var<private> carried: Carried;

// The path's own ray.
const OWN: u32 = 0u;
// No ray: the path ended on a surface, or by Russian roulette.
const OVER: u32 = 1u;

fn load_throughput(pixel: vec2u) {
    if DRAWS_WAVELENGTH {
        draw_wavelength(pixel);
    }
    carried = pixel_path[place_in_tile(pixel)];
}

fn store_throughput(pixel: vec2u) {
    pixel_path[place_in_tile(pixel)] = carried;
}

fn start_throughput(x: Real3) {
    carried = Carried(vec3f(1.0), 1.0, vec3f(0.0), 1.0, 0u, OWN, 0u, 0u);
    let n = medium_index(x);
    carried.camera = f32(n * n);
}

// Multiplies the throughput by `factor`, and returns `true` if it is then negligible.
fn scale_throughput(factor: vec3f) -> bool {
    carried.throughput *= factor;
    return max(carried.throughput.x, max(carried.throughput.y, carried.throughput.z)) < DARK;
}

// Adds the light that is emitted at x towards the path.
fn gather(radiance: vec3f, x: Real3) {
    let n = medium_index(x);
    var light = carried.share * carried.camera / f32(n * n) * carried.throughput * radiance;
    if COLORS_DISPERSED {
        color_dispersed(&light);
    }
    carried.gathered += light;
}
