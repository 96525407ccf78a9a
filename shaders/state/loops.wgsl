// Room for loops. Some devices stop an invocation after LOOP_BUDGET iterations of them without a word: from then on every loop ends after
// its first. For these the linker writes the counting into every loop of the program.
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

// Is there room for one more segment in this pass?
fn has_room() -> bool {
    if !COUNTS_LOOPS {
        return true;
    }
    return work < LOOP_BUDGET - SEGMENT_ROOM;
}

// Is there room for this many iterations, or does no later pass have more?
fn has_room_for(iterations: u32) -> bool {
    if !COUNTS_LOOPS {
        return true;
    }
    return work + iterations < LOOP_BUDGET - SEGMENT_ROOM || work < SEGMENT_ROOM;
}

// May loops of this pass have been cut short? Then what they came to is not to be used.
fn is_spent() -> bool {
    if !COUNTS_LOOPS {
        return false;
    }
    return work > LOOP_BUDGET - END_ROOM;
}

// At the end of what some have done side by side: who goes on without the others knows what they have counted.
fn rejoin() {
    if COUNTS_LOOPS {
        atomicMax(&lanes_work[own_lanes], work);
        work = atomicLoad(&lanes_work[own_lanes]);
    }
}
