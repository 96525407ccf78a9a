// The pixels that still want samples: every one in the first, later those that pass/refine.wgsl has listed.

fn round_pixel(own: Invocation) -> Place {
    if frame.listed == 0u {
        return grid_pixel(own);
    }
    return active_pixel(own);
}

fn end_round(followed: bool, pixel: vec2u, lane: u32) {
    workgroupBarrier();
}
