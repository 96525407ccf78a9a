// A step in closed form, which is retaken from its start.

fn stretch_step(start: Phase, end: Phase, h: Real, tau: Real) -> Stretch {
    return Stretch(start, h, tau, StepPolynomial());
}

fn stretch_phase(step: Stretch, f: Real) -> Phase {
    return retaken_step(step.start, f * step.h);
}
