// Rays on a spring: in Luneburg's lens and the gradient rod n² falls with the square of the distance, so that x″ = ∇(n²/2) is
// −ω² times the distance across the axis, and the path is a sum of a sine and a cosine (Evans and Rosenquist 1985). Nothing is
// integrated.

fn retaken_step(p: Phase, h: Real) -> Phase {
    let axis = spring_axis();
    let rate = spring_rate();
    let d = p[0] - spring_center();
    let along = dot(d, axis) * axis;
    let v_along = dot(p[1], axis) * axis;
    let across = d - along;
    let v_across = p[1] - v_along;
    let turn = real_sin_cos(rate * h);
    let x = spring_center() + along + h * v_along + turn.y * across + (turn.x / rate) * v_across;
    return Phase(x, v_along + turn.y * v_across - (rate * turn.x) * across);
}

fn accepted_step(ray: Ray) -> Ray {
    let h = limited_step(stride(ray.phase), ray);
    return after_step(ray, retaken_step(ray.phase, h), h);
}
