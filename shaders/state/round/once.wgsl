// Every pixel, in every round.

fn round_pixel(own: Invocation) -> Place {
    return grid_pixel(own);
}

fn lane_pixels() -> u32 {
    return LANE_PIXELS;
}

fn end_round(followed: bool, pixel: vec2u, lane: u32) {
    workgroupBarrier();
}
