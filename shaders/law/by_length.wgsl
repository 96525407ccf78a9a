// Forces by arc length (as G95's iteration suggests): dx = v/|v|, dv = a(x). The path is not the Newtonian one: |v| + V is constant instead
// of ½|v|² + V.

fn law_derivative(p: Phase) -> Phase {
    return Phase(normalize(p[1]), law_acceleration(p[0], law_ray_constant(p)));
}

// Returns x″, for the step control by curvature.
fn path_acceleration(p: Phase, rate: Phase) -> Real3 {
    let along = dot(rate[1], rate[0]) * rate[0];
    return (rate[1] - along) / length(p[1]);
}
