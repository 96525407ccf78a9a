// Between two colours, several times over (thesis 2.4.3).

const WRAPPED: u32 = 4u;

fn density_wrapped(filter_at: Filter, q: Real3, sum: f32) -> vec3f {
    return density_of(mix(filter_at.color, filter_at.high, fract(filter_at.times * texture_share(filter_at, sum))));
}
