// Rejected tries, summed like steps.

var<workgroup> group_rejected: atomic<u32>;

fn tally_rejections(n: u32) {
    atomicAdd(&group_rejected, n);
}

fn total_rejections(lane: u32) {
    if lane == 0u {
        let sum = atomicLoad(&group_rejected);
        if atomicAdd(&tally.rejected, sum) > 0xffffffffu - sum {
            atomicAdd(&tally.rejected_over, 1u);
        }
    }
}
