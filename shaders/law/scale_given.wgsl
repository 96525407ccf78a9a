// A law with a characteristic length from the scene: returns the tau to go that far.

fn law_scale(p: Phase) -> Real {
    return own_scale.scale / length(p[1].xyz);
}
