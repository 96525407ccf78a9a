// The light of rays' first crossing of a translucent surface, of their second and of their third, each for itself: luminance.

@group(0) @binding(171) var order_first: texture_storage_2d<r32float, read_write>;
@group(0) @binding(172) var order_second: texture_storage_2d<r32float, read_write>;
@group(0) @binding(173) var order_third: texture_storage_2d<r32float, read_write>;

// The samples' sums, like the colours'. light: what the pixel's ray adds to the picture.
fn add_order(pixel: vec2u, light: vec3f) {
    var sums = vec3f(textureLoad(order_first, pixel).x, textureLoad(order_second, pixel).x, textureLoad(order_third, pixel).x);
    sums = select(sums, vec3f(0.0), sum_begins());
    load_branches(pixel);
    let crossing = select(0u, branches_met(), is_settled());
    sums += dot(light, vec3f(0.2126, 0.7152, 0.0722)) * vec3f(vec3u(crossing) == vec3u(1u, 2u, 3u));
    textureStore(order_first, pixel, vec4f(sums.x));
    textureStore(order_second, pixel, vec4f(sums.y));
    textureStore(order_third, pixel, vec4f(sums.z));
}
