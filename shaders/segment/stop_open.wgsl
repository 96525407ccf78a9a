// Where a last step is taken again to: the bounding sphere and what captures. What is hit is found without.

fn stops_inside(code: u32) -> bool {
    return code == ESCAPED || code == CAPTURED;
}

fn stop_gap(code: u32, hit: Hit, x: Real3) -> Real4 {
    return open_gap(code, x);
}

fn first_guess(code: u32, hit: Hit, step: LastStep) -> Real {
    return open_guess(code, step);
}
