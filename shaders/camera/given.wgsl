// Rays given one by one, for `trace`: x and v are taken as they are, wherever the ray starts. A pixel is only a ray's number.

struct GivenRay {
    x: Real3,
    v: Real3,
}

var<storage, read> given: array<GivenRay>;

fn picture_ray(pixel: vec2u) -> CameraRay {
    let index = pixel.y * frame.image.x + pixel.x;
    let last = arrayLength(&given) - 1u;
    let ray = given[min(index, last)];
    // Pixels past the last ray have none.
    return CameraRay(ray.x, ray.v, select(ALIVE, OUTSIDE, index > last));
}
