// What an embedded pair remembers: the size of the step to try next, the error of the last accepted one (for the PI controller),
// and the rate at its end, which is the next step's first ("first same as last"). The rate is not kept between passes: it is
// the same function of the same state, evaluated again.

struct Memory {
    h: Real,
    error: Real,
    rate: Phase,
}

// Of the step before a path's first.
const FIRST_ERROR: Real = 1e-4;

fn first_memory(p: Phase) -> Memory {
    return Memory(opaque(first_step(p)), FIRST_ERROR, opaque_phase(first_derivative(p)));
}

fn recalled(h: Real, error: Real, p: Phase) -> Memory {
    return Memory(h, error, opaque_phase(first_derivative(p)));
}

fn remembered_error(memory: Memory) -> Real {
    return memory.error;
}
