// One step to where the path leaves a sphere about the spring's centre: with q = 2 d·v/ω, m ± p = |d|² ± |v|²/ω² over 2,
// r² = m + p cos 2ωτ + ½q sin 2ωτ, which passes R² outwards at 2ωτ = φ − arccos((R² − m)/√(p² + q²/4)).

fn stride(p: Phase) -> Real {
    let rate = spring_rate();
    let d = p[0] - spring_center();
    let w = p[1] / rate;
    let mean = 0.5 * (dot(d, d) + dot(w, w));
    let c = 0.5 * dot(d - w, d + w);
    let s = dot(d, w);
    let swing = sqrt(c * c + s * s);
    let r2 = here().radius * here().radius;
    let off = r2 - mean;
    let angle = arc_tangent(s, c) - arc_tangent(sqrt(max((swing - off) * (swing + off), 0.0)), off);
    return 0.5 * next_turn(angle, s >= 0.0 && dot(d, d) >= (1.0 - LAST_PART) * r2) / rate;
}
