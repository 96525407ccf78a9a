// The classical Runge–Kutta method of order 4 (Hairer, Nørsett, Wanner, Solving ODEs I, Table II.1.2).

const STEP_ORDER: f32 = 4.0;

fn step_ray(p: Phase, h: Real) -> Phase {
    let k1 = law_derivative(p);
    let k2 = law_derivative(p + (0.5 * h) * k1);
    let k3 = law_derivative(p + (0.5 * h) * k2);
    let k4 = law_derivative(p + h * k3);
    return p + (h * (1.0 / 6.0)) * (k1 + 2.0 * (k2 + k3) + k4);
}
