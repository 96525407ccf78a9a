// Finds the rays that ended with this segment (W04 §4.1). An ended ray stays at the start of the segment; the others continue from its end.

@compute @workgroup_size(GROUP)
fn terminate(own: Invocation) {
    let spot = active_ray(own);
    var code = segment_status(load_segment(spot.pixel), load_tau(spot.pixel), spot.index, load_hit(spot.pixel));
    code = select(code, UNFINISHED, walk_unfinished(spot.pixel));
    let lives = spot.alive && code == ALIVE;
    if TRANSFERS {
        transfer_segment(spot, lives);
    }
    if KEEPS_LENGTH {
        if lives {
            add_segment_length(spot.pixel);
        }
    }
    if spot.alive {
        let next = status_word(ALIVE, dispatch.end, spot.index + 1u);
        store_status(spot.pixel, select(status_word(code, dispatch.start, spot.index), next, lives));
        tally_segments(1u);
    }
    keep_active(lives || (spot.alive && may_scatter(code)), spot.pixel, own.lane);
    total_segments(own.lane);
}
