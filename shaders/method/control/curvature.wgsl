// Step sizes by the curvature of the ray (G95 Fig. 6b): h ∝ 1/κ with κ = |v × a|/|v|³, so that every step turns through the same angle. On
// a straight ray this would be unbounded: h ≤ η · scale as everywhere.

struct Control {
    // The angle that a step turns through, in radians.
    turn: Real,
    // The factor η of the limit h ≤ η · scale.
    eta: Real,
}

var<uniform> control: Control;

fn planned_step(p: Phase) -> Real {
    let rate = law_derivative(p);
    let v = rate[0].xyz;
    // κ |v| = |v × a|/|v|²: the angle turned through per unit of tau.
    let bend = length(cross(v, path_acceleration(p, rate)));
    let cap = control.eta * law_scale(p);
    return select(cap, min(control.turn * dot(v, v) / bend, cap), bend > 0.0);
}
