// No ray goes on from a flat surface.

fn load_last_hit(pixel: vec2u, index: u32) {
}

fn store_last_hit(pixel: vec2u, index: u32) {
}

fn set_last_hit(primitive: u32) {
}

fn clear_last_hit() {
}

fn is_last_hit(primitive: u32) -> bool {
    return false;
}
