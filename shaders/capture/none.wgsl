// Nothing captures rays.

fn law_captured(x: Real3, v: Real3) -> bool {
    return false;
}

fn capture_gap(x: Real3) -> Real4 {
    return Real4(0.0);
}
