// Every pixel, in every round.

fn round_pixel(group: vec3u, groups: vec3u, lane: u32) -> Place {
    return grid_pixel(group, lane);
}

fn end_round(followed: bool, pixel: vec2u, lane: u32) {
    workgroupBarrier();
}
