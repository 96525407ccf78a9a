// One step of an embedded pair.

struct PairStep {
    end: Phase,
    // The difference of the two methods.
    error: Phase,
    // At the end: the next step's first.
    rate: Phase,
}
