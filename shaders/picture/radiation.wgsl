// Intensities and optical depths at the frequencies of the scene: of one path, and their sums over the samples of a pixel.

var<storage, read_write> pixel_transfer: array<array<Real2, CHANNELS>>;
var<storage, read_write> pixel_intensity: array<array<f32, CHANNELS>>;
var<storage, read_write> pixel_optical_depth: array<array<f32, CHANNELS>>;

// The depth from which errors are relative to it.
const LEAST_DEPTH: Real = 1e-30;

// Returns the light of the path before the current step that is not in `transferred`: none.
fn earlier_light(k: u32) -> Real {
    return 0.0;
}

// Starts the transfer along the path of a pixel.
fn start_transfer(pixel: vec2u) {
    transferred = Light();
    store_transfer(pixel);
}

fn load_transfer(pixel: vec2u) {
    let place = place_in_tile(pixel);
    for (var k = 0u; k < CHANNELS; k++) {
        let kept = pixel_transfer[place][k];
        transferred.light[k] = kept.x;
        transferred.depth[k] = kept.y;
    }
}

fn store_transfer(pixel: vec2u) {
    let place = place_in_tile(pixel);
    for (var k = 0u; k < CHANNELS; k++) {
        pixel_transfer[place][k] = Real2(transferred.light[k], transferred.depth[k]);
    }
}

fn fail_transfer() {
    transferred.light[0] = not_a_number();
}

// Adds the light that a path ended on, which is the same at all frequencies where it is emitted; I/n² is constant along the path. If
// surfaces scatter light, all of it has been scaled before.
fn end_transfer(pixel: vec2u, color: vec3f, x: Real3) {
    var behind = Real((color.x + color.y + color.z) / 3.0);
    var g: Real = 1.0;
    if KNOWS_SHIFT {
        g = seen_shift;
        behind *= seen_shift * seen_shift * seen_shift;
    }
    var first: Real = 1.0;
    if !COUNTS_TRANSFER {
        first = medium_index(arrived(picture_ray(sampled_pixel(pixel))).x);
        let last = medium_index(x);
        behind /= last * last;
    }
    for (var k = 0u; k < CHANNELS; k++) {
        transferred.light[k] += transfer_exp(transferred.depth[k]) * select(behind, g * behind, k >= FREQUENCIES);
        transferred.light[k] *= first * first;
    }
    if is_not_a_number(transferred.light[0]) {
        transferred = Light();
        tally_at_once(UNDEFINED);
    }
}

// Adds the light of a path to the sums of its pixel.
fn add_radiation(pixel: vec2u) {
    let place = place_in_tile(pixel);
    for (var k = 0u; k < CHANNELS; k++) {
        let light = select(pixel_intensity[place][k], 0.0, sum_begins());
        pixel_intensity[place][k] = light + f32(transferred.light[k]);
        // All branches of a ray begin with one path.
        if frame.branch == 0u {
            let depth = select(pixel_optical_depth[place][k], 0.0, sum_begins());
            pixel_optical_depth[place][k] = depth + f32(transferred.depth[k]);
        }
    }
}

// Returns the color of a part of the brightest intensity, from black over red and yellow to white.
fn heat_color(light: f32) -> vec3f {
    let part = clamp(light / transfer.white, 0.0, 1.0);
    let display = clamp(vec3f(2.0 * part, 2.0 * part - 0.5, 2.0 * part - 1.0), vec3f(0.0), vec3f(1.0));
    return transfer.white * pow(display, vec3f(2.2));
}
