// Selects the pixels of a round, and those of the next: every pixel in the first round, later those that pass/refine.wgsl has listed, or
// those that have a path left, which the round before has stored like active rays. If none is left, all dispatches of a round are empty.

fn round_pixel(own: Invocation) -> Place {
    if LISTS_OPEN {
        if frame.listed != 0u {
            return active_pixel(own);
        }
    }
    return grid_pixel(own);
}

// Lists use one invocation per pixel.
fn lane_pixels() -> u32 {
    if LISTS_BRANCHES {
        return 1u;
    }
    if LISTS_OPEN {
        return select(1u, LANE_PIXELS, frame.listed == 0u);
    }
    return LANE_PIXELS;
}

// Ends a round. Called by every lane of the group.
fn end_round(followed: bool, pixel: vec2u, lane: u32) {
    if LISTS_BRANCHES {
        keep_active(followed && branches_left(pixel), pixel, lane);
    } else {
        workgroupBarrier();
    }
}
