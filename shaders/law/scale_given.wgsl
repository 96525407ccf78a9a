// A law that changes over a length that the scene gives: the tau to go that far.

fn law_scale(p: Phase) -> Real {
    return own_scale.scale / length(p[1].xyz);
}
