// One of the two at random, as often as its part of the light, so that every ray weighs the same.

fn load_branches(pixel: vec2u) {
}

fn store_branches(pixel: vec2u) {
}

fn begin_branches(pixel: vec2u) -> bool {
    return true;
}

fn chosen_branch(pixel: vec2u, index: u32, reflectance: f32) -> Branch {
    let whole = frame.origin + pixel;
    let seed = (whole.x * 0x9e3779b1u) ^ (whole.y * 0x85ebca77u) ^ (frame.sample * 0xc2b2ae3du) ^ (index * 0x27d4eb2fu);
    let state = seed * 747796405u + 2891336453u;
    let word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    let at = f32(((word >> 22u) ^ word) >> 8u) / 16777216.0;
    return Branch(at < reflectance, 1.0, false);
}

// Is what media add here not in another branch's sum already?
fn glow_is_new() -> bool {
    return true;
}
