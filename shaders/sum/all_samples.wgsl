// Sums run over all of a pixel's samples: the host divides once, at the end.

fn sum_begins() -> bool {
    return frame.sample + frame.branch == 0u;
}
