// A camera's rays all start inside of a mesh, or all outside.

fn starts_inside(region_bit: u32, pixel: vec2u) -> bool {
    return regions[region_bit].start == 1u;
}
