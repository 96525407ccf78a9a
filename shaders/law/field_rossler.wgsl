// The Rössler system: F = (−(y + z), x + αy, β + z(x − γ)) (G95 §2.2; W04 §5.1 prints −(x + z), a misprint).

struct Flow {
    alpha: Real,
    beta: Real,
    gamma: Real,
}

var<uniform> flow: Flow;

fn flow_field(x: Real3) -> Real3 {
    return Real3(-(x.y + x.z), x.x + flow.alpha * x.y, flow.beta + x.z * (x.x - flow.gamma));
}

// z grows and shrinks at the rate x − γ, which is of the order of γ on the attractor.
fn flow_time() -> Real {
    return 1.0 / (1.0 + abs(flow.alpha) + abs(flow.gamma));
}
