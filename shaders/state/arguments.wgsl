// The arguments of passes from the host: of the tile, of the schedule, and of the dispatch.

// The part of the image that the passes compute.
struct Frame {
    // The first pixel of the tile in the whole image.
    origin: vec2u,
    // The size of the tile.
    size: vec2u,
    // The size of the whole image.
    image: vec2u,
    // The sample of each pixel.
    sample: u32,
    // The round of that sample, if surfaces split rays and each round follows one branch: 0 for the first, 1 for all others.
    branch: u32,
    // 1 if the pixels of this round are listed, 0 if they are all pixels of the tile.
    listed: u32,
    // Always 0, but compilers cannot assume it.
    zero: u32,
}

var<uniform> frame: Frame;

// Returns the number of the sample that a pixel takes, for branches. If a branch depends on uniforms alone, lavapipe compiles the pass
// again for every dispatch; with the coordinates of the pixel in it, the number is not uniform.
fn sample_of(pixel: vec2u) -> u32 {
    return frame.sample ^ ((pixel.x ^ pixel.y) & frame.zero);
}

// Returns the index of a pixel in lists over the tile.
fn place_in_tile(pixel: vec2u) -> u32 {
    return pixel.y * frame.size.x + pixel.x;
}

// The arguments that are constant for all passes of a schedule.
struct Schedule {
    // A ray with this many segments is exhausted.
    max_segments: u32,
    // The largest number of segments per pass (`fused`).
    segments: u32,
}

var<uniform> schedule: Schedule;

// The arguments that change from dispatch to dispatch.
struct Dispatch {
    // The slot of the segment's start.
    start: u32,
    // The slot of the segment's end.
    end: u32,
    // 1 to resume suspended walks.
    again: u32,
    // 1 for the first segments of a round: they run over all pixels of its setup, whether their rays are alive or not.
    first: u32,
}

var<uniform> dispatch: Dispatch;
