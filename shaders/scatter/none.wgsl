// Surfaces end the rays that meet them.

fn goes_on(code: u32) -> bool {
    return false;
}
