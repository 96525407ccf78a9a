// Sums run over the branches of one sample: samples are added up by pass/refine.wgsl, which needs each by itself.

fn sum_begins() -> bool {
    return frame.branch == 0u;
}
