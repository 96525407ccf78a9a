// A transparent sky behind rays that carry light with them. Matter scatters light into all directions: behind it nothing is seen.

fn see_through(pixel: vec2u, code: u32, x: Real3) {
    if carried.flight != OVER && carried.recorded == 0u && (code == ESCAPED || code == MISSED) {
        let n = medium_index(x);
        uncover(pixel, carried.camera / f32(n * n) * carried.weight);
    }
}
