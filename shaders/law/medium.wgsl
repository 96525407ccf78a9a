// A medium whose index n varies with place: dx = v, dv = ∇(n²/2) = n∇n, with |v| = n kept along a ray (the F = ma form of
// Evans and Rosenquist 1985 for the thesis' Eq. 15; dτ = ds/n).

fn law_rate(p: Phase) -> Phase {
    let n = medium_index(p[0]);
    return Phase(p[1], n.w * n.xyz);
}

fn law_start(x: vec3f, v: vec3f) -> Phase {
    return Phase(x, medium_index(x).w * normalize(v));
}

fn law_settled(p: Phase) -> Phase {
    return p;
}

fn law_scale(p: Phase) -> f32 {
    return medium_length(p[0]) / length(p[1]);
}
