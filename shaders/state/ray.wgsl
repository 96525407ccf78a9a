// A ray as the state holds it, and a word of status beside it.

@group(0) @binding(14) var status: texture_storage_2d<r32uint, read_write>;

fn load_status(pixel: vec2u) -> u32 {
    return textureLoad(status, pixel).x;
}

fn store_status(pixel: vec2u, word: u32) {
    textureStore(status, pixel, vec4u(word));
}

fn load_ray(pixel: vec2u, word: u32) -> Ray {
    let x = load_x(pixel);
    let v = load_v(pixel);
    let counts = load_counts(pixel);
    let phase = unpack_phase(x, v, pixel);
    return Ray(phase, x.w, load_memory(pixel, v.w, phase), 0.0, status_index(word), counts.x, counts.y, status_code(word));
}

fn store_ray(pixel: vec2u, ray: Ray) {
    put_state(pixel, Real4(ray.phase[0].xyz, ray.tau), Real4(ray.phase[1].xyz, ray.memory.h));
    store_clock(pixel, ray.phase);
    store_memory(pixel, ray.memory);
}
