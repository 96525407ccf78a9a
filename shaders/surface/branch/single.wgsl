// One of the two: at random, as often as its part of the light, so that every ray weighs the same; or the transmitted one, for rays that
// are traced, which have no weight.

fn load_branches(pixel: vec2u) {
}

fn store_branches(pixel: vec2u) {
}

fn begin_branches(pixel: vec2u) -> bool {
    return true;
}

fn chosen_branch(pixel: vec2u, index: u32, reflectance: f32) -> Branch {
    if FOLLOWS_PATHS {
        // The choices at one surface lie in the upper bits.
        return Branch(path_point(pixel, BRANCH + (index >> 16u)).x < reflectance, 1.0, false);
    }
    if !DRAWS {
        return Branch(false, 1.0, false);
    }
    let whole = frame.origin + pixel;
    let seed = (whole.x * 0x9e3779b1u) ^ (whole.y * 0x85ebca77u) ^ (frame.sample * 0xc2b2ae3du) ^ (index * 0x27d4eb2fu);
    return Branch(f32(hashed(seed) >> 8u) / 16777216.0 < reflectance, 1.0, false);
}

// Is what media add here not in another branch's sum already?
fn glow_is_new() -> bool {
    return true;
}
