// Totals over all rays, summed on the device.

struct Tally {
    // Counts beyond 32 bits: the low word, and how often it has run over.
    steps: atomic<u32>,
    steps_over: atomic<u32>,
    segments: atomic<u32>,
    segments_over: atomic<u32>,
    rejected: atomic<u32>,
    rejected_over: atomic<u32>,
    // By status code.
    fates: array<atomic<u32>, 10>,
}

@group(0) @binding(7) var<storage, read_write> tally: Tally;

var<workgroup> group_steps: atomic<u32>;
var<workgroup> group_segments: atomic<u32>;

// Each of these is called by every lane of the group, and adds to the device's total once for all of them.
fn tally_steps(n: u32, lane: u32) {
    atomicAdd(&group_steps, n);
    workgroupBarrier();
    if lane == 0u {
        let sum = atomicLoad(&group_steps);
        if atomicAdd(&tally.steps, sum) > 0xffffffffu - sum {
            atomicAdd(&tally.steps_over, 1u);
        }
    }
}

fn tally_segments(n: u32, lane: u32) {
    atomicAdd(&group_segments, n);
    workgroupBarrier();
    if lane == 0u {
        let sum = atomicLoad(&group_segments);
        if atomicAdd(&tally.segments, sum) > 0xffffffffu - sum {
            atomicAdd(&tally.segments_over, 1u);
        }
    }
}

var<workgroup> group_fates: array<atomic<u32>, 10>;

// Called by every lane of the group.
fn tally_fate(counts: bool, code: u32, lane: u32) {
    if counts {
        atomicAdd(&group_fates[min(code, OUTSIDE)], 1u);
    }
    workgroupBarrier();
    if lane <= OUTSIDE {
        let n = atomicLoad(&group_fates[lane]);
        if n > 0u {
            atomicAdd(&tally.fates[lane], n);
        }
    }
}
