// The Lorenz system (G95 §2.2, W04 §5.1): F = (σ(y − x), ρx − y − xz, xy − βz).

struct Flow {
    sigma: Real,
    rho: Real,
    beta: Real,
}

var<uniform> flow: Flow;

fn flow_field(x: Real3) -> Real3 {
    return Real3(flow.sigma * (x.y - x.x), x.x * (flow.rho - x.z) - x.y, x.x * x.y - flow.beta * x.z);
}

// Returns the time constant of the fastest rate, at which volumes shrink.
fn flow_time() -> Real {
    return 1.0 / (flow.sigma + 1.0 + flow.beta);
}
