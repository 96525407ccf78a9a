// Such a picture along an axis, in waves that noise disturbs (Suffern 2007): u = (1 + sin(y + a s))/2.

const MARBLE: u32 = 7u;

fn density_marble(filter_at: Filter, q: Real3, sum: f32) -> vec3f {
    let along = filter_at.frequency * dot(filter_at.axis, vec3f(q));
    let share = 0.5 + 0.5 * sin(along + filter_at.times * sum);
    return density_of(min(image_sample(filter_at.which, vec2f(share, 0.5), false), vec3f(1.0)));
}
