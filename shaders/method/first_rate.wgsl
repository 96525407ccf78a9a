// An embedded pair's first rate is the law's.

fn first_rate(p: Phase) -> Phase {
    return law_rate(p);
}
