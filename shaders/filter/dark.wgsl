// Media that do not glow.

fn pass_piece(filter_at: Filter, x: Real3, depth: vec4f) {
    scale_weight(exp(-depth.xyz));
}
