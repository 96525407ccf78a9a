// The memory of an embedded pair: the size of the step to try next, the error of the last accepted one (for the PI controller), and the
// rate at its end, which is the first rate of the next step ("first same as last"). The rate is not stored between passes: it is evaluated
// again from the same state.

struct Memory {
    h: Real,
    error: Real,
    rate: Phase,
}

// The assumed error of the step before the first step of a path.
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
