// An integrated step: the polynomial of order 5 through its start, middle and end, with the derivatives there. Its error is about a
// thousandth of that of a step of order 5.

fn stretch_step(start: Phase, end: Phase, h: Real, tau: Real) -> Stretch {
    let middle = retaken_step(start, 0.5 * h);
    let half = 0.5 * h;
    let a = half * law_derivative(start);
    let b = half * law_derivative(middle);
    let c = half * law_derivative(end);
    let even = 0.5 * ((end - middle) + (start - middle));
    let odd = 0.5 * (end - start) - b;
    let even_rate = 0.5 * (c - a);
    let odd_rate = 0.5 * (c + a) - b;
    let fourth = 0.5 * even_rate - even;
    let fifth = 0.5 * (odd_rate - 3.0 * odd);
    return Stretch(start, h, tau, StepPolynomial(middle, b, even - fourth, odd - fifth, fourth, fifth));
}

fn stretch_phase(step: Stretch, f: Real) -> Phase {
    let s = 2.0 * f - 1.0;
    let p = step.polynomial;
    return p.middle + s * (p.first + s * (p.second + s * (p.third + s * (p.fourth + s * p.fifth))));
}
