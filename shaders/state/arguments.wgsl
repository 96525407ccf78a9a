// What the host tells passes: of the tile, of the schedule, and of the dispatch.

// Which part of the picture the passes work on.
struct Frame {
    // The tile's first pixel in the whole picture.
    origin: vec2u,
    // The tile's size.
    size: vec2u,
    // The whole picture's size.
    image: vec2u,
    // Which sample of each pixel.
    sample: u32,
    // Which round of that sample, where surfaces split rays and each round follows one branch: 0 for the first, 1 for all others.
    branch: u32,
    // 1 where the pixels that take part in this round are listed, 0 where all of the tile do.
    listed: u32,
    // Always 0, which no compiler knows.
    zero: u32,
}

var<uniform> frame: Frame;

// A pixel's place in lists over the tile.
fn place_in_tile(pixel: vec2u) -> u32 {
    return pixel.y * frame.size.x + pixel.x;
}

// What the schedule fixes for all its passes.
struct Schedule {
    // A ray with this many segments is exhausted.
    max_segments: u32,
    // Segments a pass, at most (fused).
    segments: u32,
}

var<uniform> schedule: Schedule;

// What changes from dispatch to dispatch.
struct Dispatch {
    // The slot of the segment's start.
    start: u32,
    // The slot of the segment's end.
    end: u32,
    // 1 to go on with suspended walks.
    again: u32,
    // 1 for a round's first segments: they run over what its setup ran over, whether it lives or not.
    first: u32,
}

var<uniform> dispatch: Dispatch;
