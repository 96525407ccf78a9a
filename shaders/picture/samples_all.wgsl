// Every pixel takes every sample, and nothing is asked of corners.

// Sums run over all of a pixel's samples: the host divides once, at the end.
fn sum_begins() -> bool {
    return frame.sample + frame.branch == 0u;
}

fn sample_wanted(pixel: vec2u) -> bool {
    return true;
}

fn keep_corner(pixel: vec2u, ray: Ray, seen: Seen) {
}
