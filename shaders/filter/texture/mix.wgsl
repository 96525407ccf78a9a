// Between two colours.

const MIX: u32 = 3u;

fn density_mix(filter_at: Filter, q: Real3, sum: f32) -> vec3f {
    return density_of(mix(filter_at.color, filter_at.high, texture_share(filter_at, sum)));
}
