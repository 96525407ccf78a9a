// Layers are of a pixel's first sample: positions and ids have no average.

fn layers_wanted() -> bool {
    return frame.sample + frame.branch == 0u;
}
