// The Dormand–Prince pair of orders 5 and 4 (1980; Hairer, Nørsett, Wanner, Solving ODEs I, Table II.5.2), first same as last.

const STEP_ORDER: f32 = 5.0;

fn pair_step(p: Phase, k1: Phase, h: Real) -> PairStep {
    let k2 = law_derivative(p + (h / 5.0) * k1);
    let k3 = law_derivative(p + (h / 40.0) * (3.0 * k1 + 9.0 * k2));
    let k4 = law_derivative(p + (h / 45.0) * (44.0 * k1 - 168.0 * k2 + 160.0 * k3));
    let k5 = law_derivative(p + (h / 6561.0) * (19372.0 * k1 - 76080.0 * k2 + 64448.0 * k3 - 1908.0 * k4));
    let k6 = law_derivative(
        p + h * ((9017.0 / 3168.0) * k1 - (355.0 / 33.0) * k2 + (46732.0 / 5247.0) * k3 + (49.0 / 176.0) * k4
            - (5103.0 / 18656.0) * k5),
    );
    let end = p + h * ((35.0 / 384.0) * k1 + (500.0 / 1113.0) * k3 + (125.0 / 192.0) * k4 - (2187.0 / 6784.0) * k5
        + (11.0 / 84.0) * k6);
    let k7 = opaque_phase(law_derivative(end));
    let error = h * ((71.0 / 57600.0) * k1 - (71.0 / 16695.0) * k3 + (71.0 / 1920.0) * k4 - (17253.0 / 339200.0) * k5
        + (22.0 / 525.0) * k6 - (1.0 / 40.0) * k7);
    return PairStep(end, error, k7);
}
