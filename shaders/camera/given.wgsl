// Reads rays that are given one by one, for `trace`: x and v are taken as they are, wherever the ray starts. A pixel is only the index of a
// ray.

struct GivenRay {
    x: Real3,
    v: Real3,
}

var<storage, read> given: array<GivenRay>;

fn picture_ray(pixel: vec2u) -> CameraRay {
    let index = pixel.y * frame.image.x + pixel.x;
    let last = arrayLength(&given) - 1u;
    let ray = given[min(index, last)];
    // Pixels beyond the last ray have no ray.
    return CameraRay(ray.x, ray.v, select(ALIVE, OUTSIDE, index > last));
}
