// Media that glow: d(L/n²)/ds = ε/n² − σ L/n², with ε and σ even over a piece.

// Whether what media add on this stretch is in no other branch's sum.
var<private> glow_counts: bool;

fn note_glow() {
    glow_counts = glow_is_new();
}

fn pass_piece(filter_at: Filter, x: Real3, depth: vec4f) {
    // (1 − e⁻ᵃ)/a, by its series where the difference would keep no digits.
    let a = depth.xyz;
    let share = select((1.0 - exp(-a)) / max(a, vec3f(1e-30)), 1.0 - a * (0.5 - a / 6.0), a < vec3f(1e-2));
    if glow_counts {
        gather(depth.w * share * filter_at.glow, x);
    }
    scale_weight(exp(-a));
}
