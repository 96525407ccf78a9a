// The Nyström method of order 4 for x″ = a(x) (Hairer, Nørsett, Wanner, Solving ODEs I, §II.14): three evaluations per step where RK4 has
// four. A value that the law holds constant along a ray (h² of a Schwarzschild black hole) is evaluated at the start of each step.

const STEP_ORDER: f32 = 4.0;

fn step_ray(p: Phase, h: Real) -> Phase {
    let constant = law_ray_constant(p);
    let a1 = law_acceleration(p[0], constant);
    let a2 = law_acceleration(p[0] + (0.5 * h) * (p[1] + (0.25 * h) * a1), constant);
    let a3 = law_acceleration(p[0] + h * (p[1] + (0.5 * h) * a2), constant);
    let sixth = h * (1.0 / 6.0);
    let x = p[0] + h * (p[1] + sixth * (a1 + 2.0 * a2));
    return Phase(x, p[1] + sixth * (a1 + 4.0 * a2 + a3));
}
