// Leapfrog: drift half a step, kick, drift the other half (the position form of Verlet's method). Of the same order and as
// reversible as the velocity form, with one evaluation a step and nothing to remember. What the law holds constant along a ray
// (h² of a Schwarzschild hole) is evaluated at each step's start.

const STEP_ORDER: f32 = 2.0;

fn step_ray(p: Phase, h: Real) -> Phase {
    let held = law_held(p);
    let middle = p[0] + (0.5 * h) * p[1];
    let v = p[1] + h * law_acceleration(middle, held);
    return Phase(middle + (0.5 * h) * v, v);
}
