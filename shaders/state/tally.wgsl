// Totals over all rays, summed on the device.

// Room for every status code.
const STATUSES: u32 = 16u;

struct Tally {
    // Counts beyond 32 bits: the low word, and how often it has run over.
    steps: atomic<u32>,
    steps_over: atomic<u32>,
    segments: atomic<u32>,
    segments_over: atomic<u32>,
    rejected: atomic<u32>,
    rejected_over: atomic<u32>,
    // By status code.
    statuses: array<atomic<u32>, STATUSES>,
}

@group(0) @binding(3) var<storage, read_write> tally: Tally;

var<workgroup> group_steps: atomic<u32>;
var<workgroup> group_segments: atomic<u32>;

// Each ray's part is added up within its group first. `tally_…` is called by every lane that has something to add, `total_…` by
// every lane, behind a barrier of the group: once for all of them it adds to the device's totals.
fn tally_steps(n: u32) {
    atomicAdd(&group_steps, n);
}

fn total_steps(lane: u32) {
    if lane == 0u {
        let sum = atomicLoad(&group_steps);
        if atomicAdd(&tally.steps, sum) > 0xffffffffu - sum {
            atomicAdd(&tally.steps_over, 1u);
        }
    }
}

fn tally_segments(n: u32) {
    atomicAdd(&group_segments, n);
}

fn total_segments(lane: u32) {
    if lane == 0u {
        let sum = atomicLoad(&group_segments);
        if atomicAdd(&tally.segments, sum) > 0xffffffffu - sum {
            atomicAdd(&tally.segments_over, 1u);
        }
    }
}

var<workgroup> group_statuses: array<atomic<u32>, STATUSES>;

fn tally_status(code: u32) {
    atomicAdd(&group_statuses[min(code, STATUSES - 1u)], 1u);
}

fn total_statuses(lane: u32) {
    if lane < STATUSES {
        let n = atomicLoad(&group_statuses[lane]);
        if n > 0u {
            atomicAdd(&tally.statuses[lane], n);
        }
    }
}
