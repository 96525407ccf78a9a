// Every pixel's colour, summed over what shading adds to it.

@group(0) @binding(152) var red: texture_storage_2d<r32float, read_write>;
@group(0) @binding(153) var green: texture_storage_2d<r32float, read_write>;
@group(0) @binding(154) var blue: texture_storage_2d<r32float, read_write>;

fn load_color(pixel: vec2u) -> vec3f {
    return vec3f(textureLoad(red, pixel).x, textureLoad(green, pixel).x, textureLoad(blue, pixel).x);
}

fn add_color(pixel: vec2u, c: vec3f) {
    let first = sum_begins();
    textureStore(red, pixel, vec4f(c.x + select(textureLoad(red, pixel).x, 0.0, first)));
    textureStore(green, pixel, vec4f(c.y + select(textureLoad(green, pixel).x, 0.0, first)));
    textureStore(blue, pixel, vec4f(c.z + select(textureLoad(blue, pixel).x, 0.0, first)));
}
