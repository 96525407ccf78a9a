// Steps that a cubic arc follows to 1e-4 of their length.

fn stride(p: Phase) -> Real {
    return 0.4 / spring_rate();
}
