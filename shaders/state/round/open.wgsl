// The pixels that have a path left: all of them in a sample's first round, later those that the round before has kept, by the
// same means as the living. With none left a round's dispatches are all empty.

fn round_pixel(own: Invocation) -> Place {
    if frame.listed == 0u {
        return grid_pixel(own);
    }
    return living_pixel(own);
}

// Called by every lane of the group.
fn end_round(followed: bool, pixel: vec2u, lane: u32) {
    keep_living(followed && branches_left(pixel), pixel, lane);
}
