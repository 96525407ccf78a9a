// An embedded pair's first rate is the law's.

fn first_derivative(p: Phase) -> Phase {
    return law_derivative(p);
}
