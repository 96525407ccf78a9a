// Nothing captures rays.

fn law_captured(x: Real3, v: Real3) -> bool {
    return false;
}

fn inside_capture(x: Real3) -> bool {
    return false;
}

// About the only centre.
fn captured_within() -> Real {
    return 0.0;
}

fn capture_gap(x: Real3) -> Real4 {
    return Real4(0.0);
}
