// How many of a pixel's samples are of the picture: where the camera has no rays there is nothing to see through it.

@group(0) @binding(155) var alpha: texture_storage_2d<r32float, read_write>;

// The samples' sum, like the colours'; but not that of the rounds in which a sample's branches are followed.
fn add_coverage(pixel: vec2u, code: u32) {
    if frame.branch == 0u {
        let before = select(textureLoad(alpha, pixel).x, 0.0, sum_begins());
        textureStore(alpha, pixel, vec4f(before + select(1.0, 0.0, code == OUTSIDE)));
    }
}

fn load_coverage(pixel: vec2u) -> f32 {
    return textureLoad(alpha, pixel).x;
}
