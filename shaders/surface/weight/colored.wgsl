// What the light at a ray's end counts for at the camera: the parts that surfaces reflect or let through, and, since L/n² is kept
// along a ray (thesis Eq. 14), the square of the index where the camera is over that where the ray ends. However often the
// index changes on the way, only those two matter.

var<storage, read_write> pixel_weight: array<vec3f>;

var<private> weight: vec3f;

fn load_weight(pixel: vec2u) {
    weight = pixel_weight[place_in_tile(pixel)];
}

fn store_weight(pixel: vec2u) {
    pixel_weight[place_in_tile(pixel)] = weight;
}

fn start_weight(x: Real3) {
    let n = medium_index(x);
    weight = vec3f(f32(n * n));
}

// Is next to nothing left?
fn scale_weight(factor: vec3f) -> bool {
    weight *= factor;
    return max(weight.x, max(weight.y, weight.z)) < DARK;
}

fn end_weight(x: Real3) -> vec3f {
    let n = medium_index(x);
    return sure_weight(weight / f32(n * n));
}
