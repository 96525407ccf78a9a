// How the ray through each pixel's top left corner ended, and on which object: what tells an edge from a gradient.

@group(0) @binding(116) var corner_end: texture_storage_2d<r32uint, read_write>;

fn keep_corner(pixel: vec2u, ray: Ray, seen: Seen) {
    if frame.sample + frame.branch == 0u {
        let code = select(ray.status, ESCAPED, ray.status == MISSED);
        textureStore(corner_end, pixel, vec4u(code | (seen.object << 4u)));
    }
}

fn load_corner(pixel: vec2u) -> u32 {
    return textureLoad(corner_end, pixel).x;
}
