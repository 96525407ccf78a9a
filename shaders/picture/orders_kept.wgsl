// The light of rays' first crossing of a translucent surface, of their second and of their third, each for itself: luminance.

var<storage, read_write> pixel_orders: array<vec3f>;

// The samples' sums, like the colors'. light: what the pixel's ray adds to the picture.
fn add_order(pixel: vec2u, light: vec3f) {
    let place = place_in_tile(pixel);
    let sums = select(pixel_orders[place], vec3f(0.0), sum_begins());
    load_branches(pixel);
    let crossing = select(0u, branches_met(), is_settled());
    pixel_orders[place] = sums + dot(light, vec3f(0.2126, 0.7152, 0.0722)) * vec3f(vec3u(crossing) == vec3u(1u, 2u, 3u));
}
