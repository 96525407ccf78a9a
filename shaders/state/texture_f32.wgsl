// The state of every pixel's ray between passes, in the paper's two textures (W04 §3.1): X = (x, tau), V = (v, h), each
// ping-ponged; and a word of status beside them.

@group(0) @binding(10) var x_in: texture_2d<f32>;
@group(0) @binding(11) var v_in: texture_2d<f32>;
@group(0) @binding(12) var x_out: texture_storage_2d<rgba32float, write>;
@group(0) @binding(13) var v_out: texture_storage_2d<rgba32float, write>;
@group(0) @binding(14) var status: texture_storage_2d<r32uint, read_write>;

fn load_status(pixel: vec2u) -> u32 {
    return textureLoad(status, pixel).x;
}

fn store_status(pixel: vec2u, word: u32) {
    textureStore(status, pixel, vec4u(word));
}

fn load_ray(pixel: vec2u, word: u32) -> Ray {
    let x = textureLoad(x_in, pixel, 0);
    let v = textureLoad(v_in, pixel, 0);
    let counts = load_counts(pixel);
    return Ray(unpack_phase(x, v, pixel), x.w, v.w, 0.0, status_index(word), counts.x, counts.y, status_code(word));
}

fn store_ray(pixel: vec2u, ray: Ray) {
    textureStore(x_out, pixel, vec4f(ray.phase[0].xyz, ray.tau));
    textureStore(v_out, pixel, vec4f(ray.phase[1].xyz, ray.h));
    store_clock(pixel, ray.phase);
}
