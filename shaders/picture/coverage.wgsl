// How many of a pixel's samples are of the picture. Where the camera has no rays nothing is, and of a transparent sky a part may be seen.
// Matter scatters light into all directions: behind it nothing is seen.

var<storage, read_write> pixel_alpha: array<f32>;

// The samples' sum, like the colours'; but not that of the rounds in which a sample's branches are followed.
fn add_coverage(pixel: vec2u, code: u32) {
    if !IS_TRANSPARENT {
        return;
    }
    if frame.branch == 0u {
        let place = place_in_tile(pixel);
        pixel_alpha[place] = select(pixel_alpha[place], 0.0, sum_begins()) + select(1.0, 0.0, code == OUTSIDE);
    }
}

// So much of a sample's light would come from behind the picture: 1 where nothing is before that.
fn uncover(pixel: vec2u, passed: vec3f) {
    let part = clamp((passed.x + passed.y + passed.z) / 3.0, 0.0, 1.0);
    pixel_alpha[place_in_tile(pixel)] -= part;
}

fn load_coverage(pixel: vec2u) -> f32 {
    if !IS_TRANSPARENT {
        return 1.0;
    }
    return max(pixel_alpha[place_in_tile(pixel)], 0.0);
}

// What is seen through a transparent sky, by rays that carry light with them and by others.
fn see_through(pixel: vec2u, code: u32, x: Real3) {
    if CARRIES_LIGHT {
        if carried.flight != OVER && carried.recorded == 0u && (code == ESCAPED || code == MISSED) {
            let n = medium_index(x);
            uncover(pixel, carried.camera / f32(n * n) * carried.weight);
        }
    } else {
        if code == ESCAPED || code == MISSED {
            uncover(pixel, end_weight(x));
        }
    }
}
