// The colours of a picture's middle row, from left to right.

const RAMP: u32 = 6u;

fn density_ramp(filter_at: Filter, q: Real3, sum: f32) -> vec3f {
    return density_of(min(image_sample(filter_at.which, vec2f(texture_share(filter_at, sum), 0.5), false), vec3f(1.0)));
}
