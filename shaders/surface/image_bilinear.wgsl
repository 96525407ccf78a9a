// The bilinear sample of a rectangle of a texture, written out: the same on every device, and pictures need no samplers.

// uv from the rectangle's top left; outside it what is in it repeats, or its edges go on.
fn image_bilinear(image: u32, corner: vec2u, size: vec2u, uv: vec2f, repeats: bool) -> vec3f {
    let p = uv * vec2f(size) - 0.5;
    let base = floor(p);
    let f = p - base;
    let lo = corner + image_index(vec2i(base), size, repeats);
    let hi = corner + image_index(vec2i(base) + 1, size, repeats);
    let top = mix(image_texel(image, lo), image_texel(image, vec2u(hi.x, lo.y)), f.x);
    let bottom = mix(image_texel(image, vec2u(lo.x, hi.y)), image_texel(image, hi), f.x);
    return mix(top, bottom, f.y);
}

fn image_index(p: vec2i, size: vec2u, repeats: bool) -> vec2u {
    let n = vec2i(size);
    return vec2u(select(clamp(p, vec2i(0), n - 1), (p % n + n) % n, repeats));
}
