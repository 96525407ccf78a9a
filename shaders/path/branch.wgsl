// One of two rays at random, as often as its part of the light, so that every ray weighs the same: as surface/branch/random.wgsl, with
// a path's own points.

fn load_branches(pixel: vec2u) {
}

fn store_branches(pixel: vec2u) {
}

fn begin_branches(pixel: vec2u) -> bool {
    return true;
}

fn chosen_branch(pixel: vec2u, index: u32, reflectance: f32) -> Branch {
    // The choices at one surface lie in the upper bits.
    return Branch(path_point(pixel, BRANCH + (index >> 16u)).x < reflectance, 1.0, false);
}

// Is what media add here not in another branch's sum already?
fn glow_is_new() -> bool {
    return true;
}
