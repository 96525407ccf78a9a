// The throughput of a ray: the factor of the light at its end, as seen by the camera. It is the product of the fractions that surfaces
// reflect or transmit and, since L/n² is constant along a ray (T Eq. 14), the squared index at the camera divided by the squared index
// at the end of the ray. However often the index changes on the way, only those two matter.

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

// Multiplies the throughput by `factor`, and returns `true` if it is then negligible.
fn scale_weight(factor: vec3f) -> bool {
    weight *= factor;
    return max(weight.x, max(weight.y, weight.z)) < DARK;
}

fn end_weight(x: Real3) -> vec3f {
    let n = medium_index(x);
    return sure_weight(weight / f32(n * n));
}
