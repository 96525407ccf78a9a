// Closed forms have no rate.

fn first_rate(p: Phase) -> Phase {
    return p;
}
