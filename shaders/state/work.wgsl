// The count that keeps an invocation under lavapipe's limit of 65,535 loop iterations, beyond which it silently stops.

// Iterations so far, over all loops of this invocation: every loop body adds one.
var<private> work: u32;

const WORK_LIMIT: u32 = 65000u;
