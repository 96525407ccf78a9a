// Lavapipe runs the lanes of a workgroup LANES at a time, in step, and its limit of loop iterations is on what they run together: who
// waits for the others' loops uses up the limit too. So they count together, where their loops are long.

// The host sets it for processors. 0 where invocations have no such limit.
override LANES: u32 = 0u;

// The most that one of those side by side has counted.
var<workgroup> lanes_work: array<atomic<u32>, GROUP>;
var<private> own_lanes: u32;

fn begin_work(lane: u32) {
    own_lanes = lane / max(LANES, 1u);
}

// At the end of what some have done side by side: who goes on without the others knows what they have counted.
fn share_work() {
    if LANES > 0u {
        atomicMax(&lanes_work[own_lanes], work);
        work = atomicLoad(&lanes_work[own_lanes]);
    }
}
