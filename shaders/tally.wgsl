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
    fates: array<atomic<u32>, 9>,
}

@group(0) @binding(7) var<storage, read_write> tally: Tally;

var<workgroup> group_steps: atomic<u32>;
var<workgroup> group_segments: atomic<u32>;
var<workgroup> group_rejected: atomic<u32>;

// Called by every lane of the group.
fn tally_steps(steps: u32, segments: u32, rejected: u32, lane: u32) {
    atomicAdd(&group_steps, steps);
    atomicAdd(&group_segments, segments);
    atomicAdd(&group_rejected, rejected);
    workgroupBarrier();
    if lane == 0u {
        let s = atomicLoad(&group_steps);
        if atomicAdd(&tally.steps, s) > 0xffffffffu - s {
            atomicAdd(&tally.steps_over, 1u);
        }
        let n = atomicLoad(&group_segments);
        if atomicAdd(&tally.segments, n) > 0xffffffffu - n {
            atomicAdd(&tally.segments_over, 1u);
        }
        let r = atomicLoad(&group_rejected);
        if atomicAdd(&tally.rejected, r) > 0xffffffffu - r {
            atomicAdd(&tally.rejected_over, 1u);
        }
    }
}

var<workgroup> group_fates: array<atomic<u32>, 9>;

// Called by every lane of the group.
fn tally_fate(counts: bool, code: u32, lane: u32) {
    if counts {
        atomicAdd(&group_fates[min(code, MISSED)], 1u);
    }
    workgroupBarrier();
    if lane <= MISSED {
        let n = atomicLoad(&group_fates[lane]);
        if n > 0u {
            atomicAdd(&tally.fates[lane], n);
        }
    }
}
