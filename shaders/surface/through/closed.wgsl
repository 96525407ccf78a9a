// Some surfaces are closed: whoever goes through one is inside of it, or no more.

fn pass_through(object: u32) {
    let bit = object_bits[object];
    if bit != NO_BIT {
        enter_set(region_bits() ^ (1u << bit));
    }
}
