// What changes from pass to pass: which slots of the state pair it reads and writes.

struct Turn {
    // The slot of the segment's start.
    start: u32,
    // The slot of the segment's end.
    end: u32,
    // 1 where a segment's walk is gone on with.
    again: u32,
    // 1 for a round's first segments: they run over what its setup ran over, whether it lives or not.
    first: u32,
}

@group(0) @binding(6) var<uniform> turn: Turn;
