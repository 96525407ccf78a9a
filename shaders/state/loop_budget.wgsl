// Room for loops on a device that stops an invocation after LOOP_BUDGET iterations of them without a word: from then on every loop ends after
// its first. The linker writes the counting into every loop of the program.
//
// Such a device runs the lanes of a workgroup LOOP_LANES at a time, in step, and its limit is on what they run together: who waits for the
// others' loops uses up the limit too. So they count together, where their loops are long.

// What is kept for one more segment, and for what ends a path.
const SEGMENT_ROOM: u32 = 5500u;
const END_ROOM: u32 = 2000u;

// Iterations so far, over all loops of this invocation and of those that it runs in step with.
var<private> work: u32;
// The most that one of those side by side has counted.
var<workgroup> lanes_work: array<atomic<u32>, GROUP>;
var<private> own_lanes: u32;

// Where a pass begins: the linker writes the call.
fn begin_counting(lane: u32) {
    own_lanes = lane / LOOP_LANES;
}

fn has_room() -> bool {
    return work < LOOP_BUDGET - SEGMENT_ROOM;
}

fn is_spent() -> bool {
    return work > LOOP_BUDGET - END_ROOM;
}

fn rejoin() {
    atomicMax(&lanes_work[own_lanes], work);
    work = atomicLoad(&lanes_work[own_lanes]);
}
