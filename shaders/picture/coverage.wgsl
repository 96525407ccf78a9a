// Computes the alpha of a pixel: the number of its samples that show the scene. If the camera has no ray there, alpha is 0, and a transparent
// sky may be partly visible. Matter scatters light into all directions: nothing behind it is visible.

var<storage, read_write> pixel_alpha: array<f32>;

// Adds to the sum over samples, like the colors', but only once for all branches of a sample.
fn add_coverage(pixel: vec2u, code: u32) {
    if !IS_TRANSPARENT {
        return;
    }
    if frame.branch == 0u {
        let place = place_in_tile(pixel);
        pixel_alpha[place] = select(pixel_alpha[place], 0.0, sum_begins()) + select(1.0, 0.0, code == OUTSIDE);
    }
}

// Marks the fraction `passed` of a sample's light as coming from behind the image: 1 if nothing is in front.
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

// Computes the visibility of a transparent sky, for rays with a throughput and for others.
fn see_through(pixel: vec2u, code: u32, x: Real3) {
    if CARRIES_LIGHT {
        if carried.recorded == 0u && (code == ESCAPED || code == MISSED) {
            let n = medium_index(x);
            uncover(pixel, carried.camera / f32(n * n) * carried.throughput);
        }
    } else {
        if code == ESCAPED || code == MISSED {
            uncover(pixel, end_throughput(x));
        }
    }
}
