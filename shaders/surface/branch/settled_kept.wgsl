// A path that has ended by a branching stays ended, however often a pass comes back to its surface.

const SETTLED: u32 = 0x80000000u;

fn settle() {
    branch_code |= SETTLED;
}

fn is_settled() -> bool {
    return (branch_code & SETTLED) != 0u;
}
