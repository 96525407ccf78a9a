// Steps that a cubic arc follows: short where the sphere's picture of space is stretched.

fn stride(p: Phase) -> Real {
    let d = (p[0] - media[place].center) / media[place].a;
    return 0.3 / (1.0 + 0.3 * sqrt(dot(d, d)));
}
