// Gives every pixel every sample.

// Sums run over all samples of a pixel: the host divides once, at the end.
fn sum_begins() -> bool {
    return frame.sample + frame.branch == 0u;
}

// The margin around a tile only has the rays of the grid.
fn sample_wanted(pixel: vec2u) -> bool {
    if !HAS_GRID {
        return true;
    }
    return is_grid(pixel) | inside_margin(pixel);
}
