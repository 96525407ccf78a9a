// Replaces the trial steps and the first rate of a control for closed forms, which need neither.

fn first_step(p: Phase) -> Real {
    return 0.0;
}

fn first_derivative(p: Phase) -> Phase {
    return p;
}
