// Sums totals over all rays, on the device.

// The number of entries: one for every status code, and for each of the other counts.
const STATUSES: u32 = 18u;

struct Tally {
    // Counts beyond 32 bits: the low word, and the number of its overflows.
    steps: atomic<u32>,
    steps_over: atomic<u32>,
    segments: atomic<u32>,
    segments_over: atomic<u32>,
    rejected: atomic<u32>,
    rejected_over: atomic<u32>,
    // The counts by status code.
    statuses: array<atomic<u32>, STATUSES>,
}

var<storage, read_write> tally: Tally;

var<workgroup> group_steps: atomic<u32>;
var<workgroup> group_segments: atomic<u32>;

// The counts of rays are first summed within their group. `tally_…` is called by every lane that has something to add, and `total_…` by
// every lane, after a barrier of the group: it adds to the totals of the device once per group.
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

var<workgroup> group_rejected: atomic<u32>;

fn tally_rejections(n: u32) {
    if REJECTS {
        atomicAdd(&group_rejected, n);
    }
}

fn total_rejections(lane: u32) {
    if !REJECTS {
        return;
    }
    if lane == 0u {
        let sum = atomicLoad(&group_rejected);
        if atomicAdd(&tally.rejected, sum) > 0xffffffffu - sum {
            atomicAdd(&tally.rejected_over, 1u);
        }
    }
}

var<workgroup> group_statuses: array<atomic<u32>, STATUSES>;

fn tally_status(code: u32) {
    tally_statuses(code, 1u);
}

fn tally_statuses(code: u32, n: u32) {
    atomicAdd(&group_statuses[min(code, STATUSES - 1u)], n);
}

// Adds a rare event directly, from any pass.
fn tally_at_once(code: u32) {
    atomicAdd(&tally.statuses[code], 1u);
}

// The status codes of one lane's rays: eight bits for each of the first 16 codes, for up to 255 rays. The last code is tallied at once.
struct Ends {
    counts: vec4u,
}

fn no_ends() -> Ends {
    return Ends(vec4u(0u));
}

fn with_end(ends: Ends, code: u32) -> Ends {
    let one = vec4u(1u << (8u * (code & 3u)));
    return Ends(ends.counts + select(vec4u(0u), one, vec4u(code >> 2u) == vec4u(0u, 1u, 2u, 3u)));
}

// One iteration for each code that a lane has: usually one or two.
fn tally_ends(ends: Ends) {
    var rest = ends.counts;
    while any(rest != vec4u(0u)) {
        var word = 3u;
        word = select(word, 2u, rest.z != 0u);
        word = select(word, 1u, rest.y != 0u);
        word = select(word, 0u, rest.x != 0u);
        let shift = firstTrailingBit(rest[word]) & 24u;
        let n = (rest[word] >> shift) & 0xffu;
        tally_statuses(4u * word + shift / 8u, n);
        rest -= select(vec4u(0u), vec4u(n << shift), vec4u(word) == vec4u(0u, 1u, 2u, 3u));
    }
}

fn total_statuses(lane: u32) {
    if lane < STATUSES {
        let n = atomicLoad(&group_statuses[lane]);
        if n > 0u {
            atomicAdd(&tally.statuses[lane], n);
        }
    }
}
