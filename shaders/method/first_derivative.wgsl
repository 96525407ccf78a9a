// Takes the first rate of an embedded pair from the law.

fn first_derivative(p: Phase) -> Phase {
    return law_derivative(p);
}
