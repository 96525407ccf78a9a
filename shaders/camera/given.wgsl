// Rays given one by one, for `trace`: x and v are taken as they are, wherever the ray starts.

struct GivenRay {
    x: Real3,
    v: Real3,
}

@group(0) @binding(3) var<storage, read> given: array<GivenRay>;

fn camera_ray(point: vec2f) -> CameraRay {
    let index = u32(point.y) * frame.image.x + u32(point.x);
    let last = arrayLength(&given) - 1u;
    let ray = given[min(index, last)];
    // Pixels past the last ray have none.
    return CameraRay(ray.x, ray.v, select(ALIVE, OUTSIDE, index > last));
}
