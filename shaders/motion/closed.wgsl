// Closed forms need no trial step and no first rate.

fn first_step(p: Phase) -> Real {
    return 0.0;
}

fn first_derivative(p: Phase) -> Phase {
    return p;
}
