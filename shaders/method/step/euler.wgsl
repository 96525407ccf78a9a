// The Euler method: p ← p + h F(p) (W04 Eq. 2).

const STEP_ORDER: f32 = 1.0;

fn step_ray(p: Phase, h: Real) -> Phase {
    return p + h * law_derivative(p);
}
