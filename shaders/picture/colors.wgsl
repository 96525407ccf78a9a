// Stores the color of every pixel, summed over its samples.

var<storage, read_write> pixel_color: array<vec3f>;

fn load_color(pixel: vec2u) -> vec3f {
    return pixel_color[place_in_tile(pixel)];
}

fn add_color(pixel: vec2u, c: vec3f) {
    let place = place_in_tile(pixel);
    pixel_color[place] = c + select(pixel_color[place], vec3f(0.0), sum_begins());
}
