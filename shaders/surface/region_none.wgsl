// Treats all space as one region, with one medium if it has any.

const place: u32 = 0u;

fn start_region(x: Real3, v: Real3, pixel: vec2u) {
}

fn region_bits() -> u32 {
    return 0u;
}

fn enter_set(bits: u32) {
}

fn load_region(pixel: vec2u) {
}

fn store_region(pixel: vec2u) {
}
