// What the light at a ray's end counts for at the camera: the parts that surfaces reflect or let through, and, since L/n² is kept
// along a ray (thesis Eq. 14), the square of the index where the camera is over that where the ray ends. However often the
// index changes on the way, only those two matter.

@group(0) @binding(139) var weight_red: texture_storage_2d<r32float, read_write>;
@group(0) @binding(140) var weight_green: texture_storage_2d<r32float, read_write>;
@group(0) @binding(141) var weight_blue: texture_storage_2d<r32float, read_write>;

var<private> weight: vec3f;

fn load_weight(pixel: vec2u) {
    weight = vec3f(textureLoad(weight_red, pixel).x, textureLoad(weight_green, pixel).x, textureLoad(weight_blue, pixel).x);
}

fn store_weight(pixel: vec2u) {
    textureStore(weight_red, pixel, vec4f(weight.x));
    textureStore(weight_green, pixel, vec4f(weight.y));
    textureStore(weight_blue, pixel, vec4f(weight.z));
}

fn start_weight(x: Real3) {
    let n = medium_index(x);
    weight = vec3f(f32(n * n));
}

// Returns the largest of what is left.
fn scale_weight(factor: vec3f) -> f32 {
    weight *= factor;
    return max(weight.x, max(weight.y, weight.z));
}

fn end_weight(x: Real3) -> vec3f {
    let n = medium_index(x);
    return sure_weight(weight / f32(n * n));
}
