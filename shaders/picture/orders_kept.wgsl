// Stores the luminance of each ray's first, second and third crossing of a translucent surface, separately (the image orders).

var<storage, read_write> pixel_orders: array<vec3f>;

// Adds to the sums over samples, like the colors'. light: the contribution of the pixel's ray to the image.
fn add_order(pixel: vec2u, light: vec3f) {
    let place = place_in_tile(pixel);
    let sums = select(pixel_orders[place], vec3f(0.0), sum_begins());
    load_branches(pixel);
    let crossing = select(0u, branches_met(), is_settled());
    pixel_orders[place] = sums + dot(light, vec3f(0.2126, 0.7152, 0.0722)) * vec3f(vec3u(crossing) == vec3u(1u, 2u, 3u));
}
