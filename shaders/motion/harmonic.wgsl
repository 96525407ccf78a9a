// Rays on a spring: in the Luneburg lens and the gradient-index rod n² falls with the square of the distance, so that x″ = ∇(n²/2) is −ω²
// times the distance vector, and the path is a sum of a sine and a cosine (Evans and Rosenquist 1985). Nothing is integrated.

fn retaken_step(p: Phase, h: Real) -> Phase {
    let axis = spring_axis();
    let rate = spring_rate();
    let d = p[0] - spring_center();
    let along = dot(d, axis) * axis;
    let v_along = dot(p[1], axis) * axis;
    let across = d - along;
    let v_across = p[1] - v_along;
    let turn = real_sin_cos(rate * h);
    let x = spring_center() + along + h * v_along + turn.y * across + (turn.x / rate) * v_across;
    return Phase(x, v_along + turn.y * v_across - (rate * turn.x) * across);
}

fn accepted_step(ray: Ray) -> Ray {
    let h = limited_step(stride(ray.phase), ray);
    return after_step(ray, retaken_step(ray.phase, h), h);
}

// Returns one step to where the path leaves a sphere around the center of the spring: with q = 2 d·v/ω, m ± p = |d|² ± |v|²/ω² over 2, r² =
// m + p cos 2ωτ + ½q sin 2ωτ, which passes R² outwards at 2ωτ = φ − arccos((R² − m)/√(p² + q²/4)). Or steps that a cubic arc follows to
// 1e-4 of their length.
fn stride(p: Phase) -> Real {
    if !IS_EMPTY {
        return 0.4 / spring_rate();
    }
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
