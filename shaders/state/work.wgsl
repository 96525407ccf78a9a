// The count that keeps an invocation under lavapipe's limit of 65,535 loop iterations, beyond which every loop ends after its first.

// Iterations so far, over all loops of this invocation and of those that it runs in step with: every loop body adds one, and so does
// every loop's end, which the linker writes.
var<private> work: u32;

// What is left is for the ends of paths, before which nothing asks for room.
const WORK_LIMIT: u32 = 60000u;
