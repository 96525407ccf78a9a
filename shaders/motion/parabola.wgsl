// Parabolas: with n² = n₀² + g·x rays fall with the constant acceleration x″ = g/2 (Evans and Rosenquist 1985). A cubic arc is the parabola
// itself, so that only objects require it to be cut into steps.

fn retaken_step(p: Phase, h: Real) -> Phase {
    let pull = medium_pull(p[0]);
    return Phase(p[0] + h * (p[1] + (0.5 * h) * pull), p[1] + h * pull);
}

// Returns a quarter of the distance through the bounding sphere, or the step that turns the ray by half a radian.
fn stride(p: Phase) -> Real {
    let pull = length(medium_pull(p[0]));
    let v = length(p[1]);
    return min(0.5 * bound.radius / v, 0.5 * v / max(pull, 1e-30));
}

fn accepted_step(ray: Ray) -> Ray {
    let h = limited_step(stride(ray.phase), ray);
    return after_step(ray, retaken_step(ray.phase, h), h);
}
