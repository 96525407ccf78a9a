// Every pixel, in every round.

fn round_pixel(own: Invocation) -> Place {
    return grid_pixel(own);
}

fn end_round(followed: bool, pixel: vec2u, lane: u32) {
    workgroupBarrier();
}
