// The pixels that still want samples: every one in the first, later those that pass/refine.wgsl has listed.

fn round_pixel(own: Invocation) -> Place {
    if frame.listed == 0u {
        return grid_pixel(own);
    }
    return active_pixel(own);
}

// Lists are run over by one invocation a pixel.
fn lane_pixels() -> u32 {
    return select(1u, LANE_PIXELS, frame.listed == 0u);
}

fn end_round(followed: bool, pixel: vec2u, lane: u32) {
    workgroupBarrier();
}
