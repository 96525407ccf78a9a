// A law of sources changes over the tau to the nearest one.

fn law_scale(p: Phase) -> Real {
    return source_distance(p[0]) / length(p[1]);
}
