// The pixels that still want samples: every one in the first, later those that pass/refine.wgsl has listed.

fn round_pixel(group: vec3u, groups: vec3u, lane: u32) -> Place {
    if frame.listed == 0u {
        return grid_pixel(group, lane);
    }
    return living_pixel(group, groups, lane);
}

fn end_round(followed: bool, pixel: vec2u, lane: u32) {
    workgroupBarrier();
}
