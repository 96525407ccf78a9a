// The Bogacki–Shampine pair of orders 3 and 2 (1989), first same as last.

const STEP_ORDER: f32 = 3.0;

fn pair_step(p: Phase, k1: Phase, h: Real) -> PairStep {
    let k2 = law_derivative(p + (0.5 * h) * k1);
    let k3 = law_derivative(p + (0.75 * h) * k2);
    let end = p + (h / 9.0) * (2.0 * k1 + 3.0 * k2 + 4.0 * k3);
    let k4 = opaque_phase(law_derivative(end));
    return PairStep(end, (h / 72.0) * (-5.0 * k1 + 6.0 * k2 + 8.0 * k3 - 9.0 * k4), k4);
}
