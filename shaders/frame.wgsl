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

@group(0) @binding(0) var<uniform> frame: Frame;
