// How many of a pixel's samples are of the picture. Where the camera has no rays nothing is, and of a transparent sky a part may be seen.

@group(0) @binding(155) var alpha: texture_storage_2d<r32float, read_write>;

// The samples' sum, like the colours'; but not that of the rounds in which a sample's branches are followed.
fn add_coverage(pixel: vec2u, code: u32) {
    if frame.branch == 0u {
        let before = select(textureLoad(alpha, pixel).x, 0.0, sum_begins());
        textureStore(alpha, pixel, vec4f(before + select(1.0, 0.0, code == OUTSIDE)));
    }
}

// So much of a sample's light would come from behind the picture: 1 where nothing is before that.
fn uncover(pixel: vec2u, passed: vec3f) {
    let part = clamp((passed.x + passed.y + passed.z) / 3.0, 0.0, 1.0);
    textureStore(alpha, pixel, vec4f(textureLoad(alpha, pixel).x - part));
}

fn load_coverage(pixel: vec2u) -> f32 {
    return max(textureLoad(alpha, pixel).x, 0.0);
}
