// Limits loop iterations. Some devices silently stop an invocation after LOOP_BUDGET iterations: from then on every loop ends after its
// first iteration. For these the linker adds the counting to every loop of the program.
//
// Such a device runs the lanes of a workgroup LOOP_LANES at a time, in step, and its limit applies to their joint execution: a lane that
// waits for the loops of others also uses up the limit. So lanes count together, if their loops are long.

// The iterations reserved for one more segment, also with the light of a stretch of an orbit, and for the end of a path.
const SEGMENT_ROOM: u32 = 5500u;
const LIT_ROOM: u32 = 20000u;
const END_ROOM: u32 = 2000u;
// The largest count that a lane does not share, because locked operations are slow. The joint execution may have LOOP_LANES times as many
// iterations more than a lane has counted.
const UNSHARED: u32 = 256u;
const COUNTED_BUDGET: u32 = LOOP_BUDGET - LOOP_LANES * UNSHARED;
// The largest number of loops that all lanes may skip together in one iteration of a pass. A skipped loop runs once, and no lane counts it.
const SKIPPED_LOOPS: u32 = 8u;

// The iterations so far, over all loops of this invocation and of those that it runs in step with.
var<private> work: u32;
// The largest count in each set of lanes that run in step.
var<workgroup> lanes_work: array<atomic<u32>, GROUP>;
var<private> own_lanes: u32;

// Starts the counting of a pass: the linker writes the call.
fn begin_counting(lane: u32) {
    own_lanes = lane / LOOP_LANES;
}

// Returns `true` if there is room for one more segment in this pass.
fn has_room() -> bool {
    if !COUNTS_LOOPS {
        return true;
    }
    return work < COUNTED_BUDGET - select(SEGMENT_ROOM, LIT_ROOM, TRANSFERS_ORBITS);
}

// Returns `true` if there is room for this many iterations, or if no later pass has more.
fn has_room_for(iterations: u32) -> bool {
    if !COUNTS_LOOPS {
        return true;
    }
    return work + iterations < COUNTED_BUDGET - SEGMENT_ROOM || work < SEGMENT_ROOM;
}

// Returns `true` if loops of this pass may have been cut short: then their results must not be used.
fn is_spent() -> bool {
    if !COUNTS_LOOPS {
        return false;
    }
    return work > COUNTED_BUDGET - END_ROOM;
}

// Equalizes the counts after a loop that lanes ran together, so that a lane that continues without the others includes their iterations.
fn rejoin() {
    if COUNTS_LOOPS {
        if work > UNSHARED {
            atomicMax(&lanes_work[own_lanes], work);
        }
        work = max(work, atomicLoad(&lanes_work[own_lanes]));
    }
}

// Counts loops that all lanes may have skipped.
fn count_skipped() {
    if COUNTS_LOOPS {
        work += SKIPPED_LOOPS;
    }
}
