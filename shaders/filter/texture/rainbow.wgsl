// Seven colours, linear between. The thesis takes its rainbow from an equation that it does not print; this one is ours.

const RAINBOW: u32 = 5u;

fn density_rainbow(filter_at: Filter, q: Real3, sum: f32) -> vec3f {
    var stops = array<vec3f, 7>(
        vec3f(0.95, 0.15, 0.15),
        vec3f(0.95, 0.55, 0.12),
        vec3f(0.95, 0.92, 0.15),
        vec3f(0.2, 0.85, 0.25),
        vec3f(0.15, 0.7, 0.95),
        vec3f(0.2, 0.25, 0.95),
        vec3f(0.65, 0.2, 0.9),
    );
    let at = 6.0 * texture_share(filter_at, sum);
    let stop = min(u32(at), 5u);
    return density_of(mix(stops[stop], stops[stop + 1u], at - f32(stop)));
}
