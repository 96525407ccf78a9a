// Leapfrog: drift half a step, kick, drift the other half (position Verlet). It has the order and reversibility of the velocity form, with
// one evaluation per step and no memory. A value that the law holds constant along a ray (h² of a Schwarzschild black hole) is evaluated at
// the start of each step.

const STEP_ORDER: f32 = 2.0;

fn step_ray(p: Phase, h: Real) -> Phase {
    let constant = law_ray_constant(p);
    let middle = p[0] + (0.5 * h) * p[1];
    let v = p[1] + h * law_acceleration(middle, constant);
    return Phase(middle + (0.5 * h) * v, v);
}
