// What the schedule fixes for all its passes.

struct Schedule {
    // A ray with this many segments is exhausted.
    max_segments: u32,
    // Segments a pass, at most (fused).
    segments: u32,
    // Loop iterations that one more segment may need.
    segment_work: u32,
}

@group(0) @binding(5) var<uniform> schedule: Schedule;
