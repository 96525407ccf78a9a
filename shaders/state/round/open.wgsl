// The pixels that have a path left: all of them in a sample's first round, later those that the round before has kept, by the
// same means as active rays. With none left a round's dispatches are all empty.

fn round_pixel(own: Invocation) -> Place {
    if frame.listed == 0u {
        return grid_pixel(own);
    }
    return active_pixel(own);
}

fn lane_pixels() -> u32 {
    return 1u;
}

// Called by every lane of the group.
fn end_round(followed: bool, pixel: vec2u, lane: u32) {
    keep_active(followed && branches_left(pixel), pixel, lane);
}
