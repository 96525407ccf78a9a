// Which pixels a round runs over, and which go on to the next: every one in the first, later those that pass/refine.wgsl has listed, or those
// that have a path left, which the round before has kept by the same means as active rays. With none left a round's dispatches are all empty.

fn round_pixel(own: Invocation) -> Place {
    if LISTS_OPEN {
        if frame.listed != 0u {
            return active_pixel(own);
        }
    }
    return grid_pixel(own);
}

// Lists are run over by one invocation a pixel.
fn lane_pixels() -> u32 {
    if LISTS_BRANCHES {
        return 1u;
    }
    if LISTS_OPEN {
        return select(1u, LANE_PIXELS, frame.listed == 0u);
    }
    return LANE_PIXELS;
}

// Called by every lane of the group.
fn end_round(followed: bool, pixel: vec2u, lane: u32) {
    if LISTS_BRANCHES {
        keep_active(followed && branches_left(pixel), pixel, lane);
    } else {
        workgroupBarrier();
    }
}
