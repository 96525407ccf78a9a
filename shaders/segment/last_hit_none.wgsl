// No ray goes on from a flat surface.

fn load_left(pixel: vec2u, index: u32) {
}

fn store_left(pixel: vec2u, index: u32) {
}

fn leave_surface(primitive: u32) {
}

fn forget_left() {
}

fn just_left(primitive: u32) -> bool {
    return false;
}
