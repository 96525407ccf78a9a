// The throughput of a ray: the factor of the light at its end, as seen by the camera. It is the product of the fractions that surfaces
// reflect or transmit and, since L/n² is constant along a ray (T Eq. 14), the squared index at the camera divided by the squared index
// at the end of the ray. However often the index changes on the way, only those two matter.

var<storage, read_write> pixel_throughput: array<vec3f>;

var<private> throughput: vec3f;

fn load_throughput(pixel: vec2u) {
    throughput = pixel_throughput[place_in_tile(pixel)];
}

fn store_throughput(pixel: vec2u) {
    pixel_throughput[place_in_tile(pixel)] = throughput;
}

fn kept_throughput() -> vec3f {
    return throughput;
}

fn restore_throughput(kept: vec3f) {
    throughput = kept;
}

fn start_throughput(x: Real3) {
    let n = medium_index(x);
    throughput = vec3f(f32(n * n));
}

// Multiplies the throughput by `factor`, and returns `true` if it is then negligible.
fn scale_throughput(factor: vec3f) -> bool {
    throughput *= factor;
    return max(throughput.x, max(throughput.y, throughput.z)) < DARK;
}

fn end_throughput(x: Real3) -> vec3f {
    let n = medium_index(x);
    return finite_throughput(throughput / f32(n * n));
}
