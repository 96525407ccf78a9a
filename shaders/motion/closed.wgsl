// Closed forms try no step and have no rate.

fn first_step(p: Phase) -> Real {
    return 0.0;
}

fn first_derivative(p: Phase) -> Phase {
    return p;
}
